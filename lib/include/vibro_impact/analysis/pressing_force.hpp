// The accelerations of a motion (Eq. 4), and the force that presses a mass, at rest at its stop,
// into the stop: the hold force of Eqs. 12-13 times the sign of the side. It is negative when the
// mass is pulled off. These functions throw std::invalid_argument for a bad scene or stop, and for
// a state that does not fit the scene.
#pragma once

#include <vector>

#include "vibro_impact/simulate.hpp"

namespace vibro_impact {

// Accelerations of all masses in the contact mode of `state`; zero for a held mass.
std::vector<double> acceleration(const Scene &scene, const MotionState &state);

// The pressing force on the mass of `stop`, which the scene need not contain. The mass counts as at
// rest at the stop; the other masses move as in `state`.
double pressing_force(const Scene &scene, const Stop &stop, const MotionState &state);

// The time derivative of the pressing force.
double pressing_force_rate(const Scene &scene, const Stop &stop, const MotionState &state);

}  // namespace vibro_impact
