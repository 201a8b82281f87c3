// Newton's method for a periodic orbit, with the motion and the derivative at the orbit.
//
// The unknowns z are the free coordinates at the section as lengths (motion.hpp). A state is an
// orbit when the motion returns to it within 1e-13 of the size of the motion, or within 1e-10 where
// rounding keeps the distance from falling further, as next to a graze. The size of a motion that
// comes to rest is that of the motion from the guess.
#pragma once

#include <string>
#include <vector>

#include "motion.hpp"
#include "vibro_impact/analysis/periodic_orbit.hpp"

namespace vibro_impact {

struct NewtonOrbit {
  Eigen::VectorXd guess = {}, image_of_guess = {};  // like z
  Eigen::VectorXd z = {};  // of the orbit, or of the iterate with the least residual
  double size = 0.0;       // of the motion
  Motion motion = {};      // over the periods of the orbit; without knots if no iterate returned
  Smooth<Eigen::MatrixXd> derivative = {};  // of the image of z by z
  bool found = false;
  std::string why_not = {};            // one line that says why it was not found
  std::vector<double> residuals = {};  // the distances of the image of z from z
};

// From a late motion, which is near to its orbit, the residuals fall from the first step on: the
// search ends where one rises, and a step that has reduced the residual much is followed by one
// with the same derivative.
enum class NewtonGuess { anywhere, late_motion };

// The orbit of a scene and near a guess that have been checked.
NewtonOrbit newton(const Scene &scene, const MotionState &guess, int periods, int most_iterations,
                   const RunOptions &options = {}, NewtonGuess kind = NewtonGuess::anywhere);

inline double largest_modulus(const Multipliers &multipliers) {
  return multipliers.empty() ? 0.0 : std::abs(multipliers.front());
}

// The eigenvalues of a matrix, largest modulus first.
Multipliers eigenvalues_of(const Eigen::MatrixXd &matrix);

Smooth<Multipliers> multipliers_of(const NewtonOrbit &orbit);
PeriodicOrbit as_periodic_orbit(const NewtonOrbit &orbit);

}  // namespace vibro_impact
