// Frequencies at which a settled motion changes, by bisection on what is counted in it.
#pragma once

#include "event_driven.hpp"

#include <cstddef>
#include <functional>

namespace vibro_impact_reference {

/// A whole number read off a run, such as the number of its sticking phases.
using Count = std::function<std::ptrdiff_t(const Run &)>;

/// The frequency between `near` and `far` at which the count changes. The settled motion is
/// followed from `near`: every trial begins at the state extrapolated from the last two frequencies
/// known to have the same count as `near`, so that the unsettled part of a trial is small beside
/// the bracket. Throws std::logic_error if the counts at the ends agree.
Real changing_frequency(const Scene &scene, const Real &near, const Real &far, const Count &count);

/// The frequency between `near` and `far` at which the count of the motion from rest jumps. Every
/// trial starts at rest. Throws as `changing_frequency` does.
Real jumping_frequency(const Scene &scene, const Real &near, const Real &far, const Count &count);

}  // namespace vibro_impact_reference
