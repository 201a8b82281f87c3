// What is zero at a multi-sliding bifurcation (Section 3.2) and at a grazing (Section 3.3): the
// least pressing force inside a sticking phase, the least gap between impacts, of the motion over
// one forcing period. Both are smooth functions of a parameter as far as the motion is.
#pragma once

#include <optional>

#include "hold_force.hpp"

namespace vibro_impact {

// A minimum, and the motion there, the cycle of the start counted as 0.
struct LeastValue {
  double value = 0.0;
  MotionState at;
};

// Least interior local minimum of the pressing force over the sticking phases of `stop` in the
// period after `start`: where it reaches zero the phase is about to split (multi-sliding). Nothing
// when the force has no minimum inside a phase.
std::optional<LeastValue> least_pressing_force(const Scene &scene, const MotionState &start,
                                               const Stop &stop);

// Least local minimum of the gap of a mass to a stop (which the scene need not contain) in the
// period after `start`: where it reaches zero the mass grazes the stop.
std::optional<LeastValue> least_gap(const Scene &scene, const MotionState &start, const Stop &stop);

}  // namespace vibro_impact
