// Periodic orbits as fixed points of the stroboscopic map, found by Newton's method with the exact
// derivative of the map; their Floquet multipliers; and the period of a settled motion.
//
// The stroboscopic map takes the state at one phase of the forcing to the state n forcing periods
// later. Masses held at that phase have no freedom: the unknowns are the displacements and
// velocities of the free ones.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <limits>
#include <stdexcept>
#include <vector>

#include "simulate.hpp"
#include "tangent.hpp"

namespace vibro_impact {

// Rows of (x_1 .. x_N, x_1' .. x_N') that belong to free masses.
std::vector<Eigen::Index> free_coordinates(const Held &held);

// (x_1 .. x_N, x_1' .. x_N').
Eigen::VectorXd coordinates(const MotionState &motion);

struct StroboscopicImage {
  MotionState state;           // n periods later, cycle count as at the start
  Eigen::MatrixXd derivative;  // 2N x 2N; rows and columns of held masses are zero
  bool differentiable = true;  // see TangentRecorder
  double chatter_error = 0.0;  // see TangentRecorder
  Counters counters;
};

namespace detail {

inline double time_after(const Scene &scene, const MotionState &start, int periods) {
  if (!(scene.omega > 0.0))
    throw std::invalid_argument(
        fmt::format("omega = {}: a stroboscopic map needs a forcing period", scene.omega));
  if (periods < 1)
    throw std::invalid_argument(fmt::format("periods = {}: must be at least 1", periods));
  return time_of({start.instant.cycle + periods, start.instant.phase}, Clock(scene.omega));
}

}  // namespace detail

// The state `periods` forcing periods after `start`, at the same phase and with the same cycle
// count. `recorders` see the run.
template <class... Recorders>
StroboscopicImage stroboscopic_map(const Scene &scene, const MotionState &start, int periods,
                                   const RunOptions &options, Recorders &...recorders) {
  const double until = detail::time_after(scene, start, periods);
  const Outcome end = simulate_from(scene, start, until, options, recorders...);
  StroboscopicImage image{end.state, {}, true, 0.0, end.counters};
  image.state.instant = start.instant;
  return image;
}

// The same with its derivative by the coordinates of the masses free at the start. `start` should
// lie away from events (`at_quiet_phase`): there the map is smooth.
StroboscopicImage stroboscopic_map_and_derivative(const Scene &scene, const MotionState &start,
                                                  int periods, const RunOptions &options);

// The motion from `start` brought to the phase, within the next forcing period, that is farthest
// from every event of that period; the cycle count is set to zero.
MotionState at_quiet_phase(const Scene &scene, const MotionState &start,
                           const RunOptions &options = {});

// The motion after `periods` forcing periods from the scene's own initial state.
MotionState settled(const Scene &scene, int periods, const RunOptions &options = {});

struct NewtonOptions {
  RunOptions run;
  int max_iterations = 20;
  // Largest component of P(z) - z at which z counts as a fixed point, relative to that of z (or 1).
  double tolerance = 1e-13;
};

struct PeriodicOrbit {
  int periods = 1;
  MotionState state;              // at the section
  Eigen::VectorXcd multipliers;   // Floquet multipliers, largest modulus first
  Eigen::MatrixXd derivative;     // of the map, as in StroboscopicImage
  bool converged = false;         // false: the rest describes the last iterate
  std::vector<double> residuals;  // largest component of P(z) - z, one per map evaluation
  double error = 0.0;             // estimated error of `state`: the size of the next Newton step
  bool differentiable = true;
  double chatter_error = 0.0;
  Counters counters;         // of the last map evaluation
  long long expansions = 0;  // of all of them: the cost of the search

  bool stable() const {
    return multipliers.size() == 0 || std::abs(multipliers(0)) < 1.0;
  }
};

// The Floquet multipliers of a map with this derivative: the eigenvalues on the free coordinates.
Eigen::VectorXcd floquet_multipliers(const Eigen::MatrixXd &derivative, const Held &held);

// Newton's method for the fixed point of the `periods`-fold stroboscopic map near `guess`, whose
// phase is the section. The contact mode at the section is that of the guess; the search ends
// without convergence when an iterate returns in another one or leaves the admissible region.
PeriodicOrbit find_periodic_orbit(const Scene &scene, const MotionState &guess, int periods = 1,
                                  const NewtonOptions &options = {});

// How often a settled motion repeats.
struct Recurrence {
  int periods = 0;        // smallest n <= most with z after n periods = z; 0 when there is none
  double distance = 0.0;  // largest component of z after `periods` periods minus z (0: the least)
};

// The period, in forcing periods, of the motion through `state`, which should lie on an attractor.
// States closer than `tolerance` count as equal. An orbit that does not repeat within `most`
// periods (quasi-periodic, chaotic, of longer period, not settled) gives 0.
Recurrence recurrence(const Scene &scene, const MotionState &state, int most = 8,
                      double tolerance = 1e-8, const RunOptions &options = {});

}  // namespace vibro_impact
