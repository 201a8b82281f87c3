// The least pressing force inside a sticking phase and the least gap between impacts, over one
// forcing period. The first is zero at a multi-sliding bifurcation (Section 3.2), the second at a
// grazing (Section 3.3). Both are smooth functions of a parameter as far as the motion is.
//
// A minimum and a maximum that are closer together than 1/8 of the fastest time scale of the chain
// may both be missed.
#pragma once

#include <optional>

#include "vibro_impact/simulate.hpp"

namespace vibro_impact {

// A minimum and the state there; the forcing period of the start has the number 0.
struct LeastValue {
  double value = 0.0;
  MotionState at;
};

// The least local minimum of the pressing force inside the sticking phases at `stop`, in the
// forcing period after `start`. Where it reaches zero the phase is about to split. Returns nullopt
// if the force has no minimum inside a phase.
std::optional<LeastValue> least_pressing_force(const Scene &scene, const MotionState &start,
                                               const Stop &stop);

// The least local minimum of the gap between a mass and a stop, which the scene need not contain,
// in the forcing period after `start`. Returns nullopt if the gap has no minimum.
std::optional<LeastValue> least_gap(const Scene &scene, const MotionState &start, const Stop &stop);

}  // namespace vibro_impact
