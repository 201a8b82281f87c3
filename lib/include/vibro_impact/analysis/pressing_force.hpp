// The natural modes of a contact mode, and the force that presses a mass, at rest at its stop, into
// it: Eqs. 12-13 times the sign of the side. Negative when the mass is pulled off.
#pragma once

#include <vector>

#include "matrix.hpp"
#include "vibro_impact/record.hpp"
#include "vibro_impact/simulate.hpp"

namespace vibro_impact {

// Squares of the natural frequencies of the free masses, ascending, and their modes normalised to
// unit modal mass: shape is N x modes, with zero rows for held masses (Eqs. 6-7).
struct NaturalModes {
  std::vector<double> lambda;
  Matrix shape;
};
// Throws std::invalid_argument for a bad scene or a contact mode that does not fit it.
NaturalModes natural_modes(const Scene &scene, const Held &held);

// Accelerations of all masses in the contact mode of `at` (Eq. 4); zero for a held mass.
std::vector<double> acceleration(const Scene &scene, const MotionState &at);

// The pressing force on the mass of `stop`, the others moving as in `at`, and its time derivative
// (there the neighbours' velocities and accelerations take the place of their displacements and
// velocities, and the stop stands).
double pressing_force(const Scene &scene, const Stop &stop, const MotionState &at);
double pressing_force_rate(const Scene &scene, const Stop &stop, const MotionState &at);

}  // namespace vibro_impact
