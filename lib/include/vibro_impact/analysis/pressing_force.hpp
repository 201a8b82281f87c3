/// \file
/// The accelerations of a motion (Eq. 4), and the force that presses a mass, at rest at its stop,
/// into the stop: the hold force of Eqs. 12-13 times the sign of the side. It is negative when the
/// mass is pulled off.
///
/// The least pressing force inside a sticking phase is zero at a multi-sliding bifurcation (Section
/// 3.2), the least gap between impacts at a grazing (Section 3.3). Both are smooth functions of a
/// parameter as far as the motion is. They are looked for over one forcing period. A minimum and a
/// maximum that are closer together than 1/8 of the fastest time scale of the chain may both be
/// missed.
///
/// All functions throw std::invalid_argument for a bad scene or stop, and for a state that does not
/// fit the scene.
#pragma once

#include <optional>
#include <vector>

#include "vibro_impact/simulate.hpp"

namespace vibro_impact {

/// Accelerations of all masses in the contact mode of `state`; zero for a held mass.
std::vector<double> acceleration(const Scene &scene, const MotionState &state);

/// The pressing force on the mass of `stop`, which the scene need not contain. The mass counts as
/// at rest at the stop; the other masses move as in `state`.
double pressing_force(const Scene &scene, const Stop &stop, const MotionState &state);

/// A minimum and the state at it. The forcing period of the start has the number 0.
struct LeastValue {
  double value = 0.0;
  MotionState at;
};

/// The least local minimum of the pressing force inside the sticking phases at `stop`, in the
/// forcing period after `start`. Where it reaches zero the phase is about to split. Returns nullopt
/// if the force has no minimum inside a phase.
std::optional<LeastValue> least_pressing_force(const Scene &scene, const MotionState &start,
                                               const Stop &stop);

/// The least local minimum of the gap between a mass and a stop, which the scene need not contain,
/// in the forcing period after `start`. Returns nullopt if the gap has no minimum.
std::optional<LeastValue> least_gap(const Scene &scene, const MotionState &start, const Stop &stop);

}  // namespace vibro_impact
