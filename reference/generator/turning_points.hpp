// The points at which a motion or a hold force comes closest to a given value.
#pragma once

#include "event_driven.hpp"

#include <cstddef>

namespace vibro_impact_reference {

/// Smallest and largest position of a mass, and when the largest is met first.
struct Extremes {
  Real lowest, highest, highest_at;
};

/// The extremes of the motion of a mass over [from, to]: at zeros of the velocity (sampled, then
/// bisected) or where one piece of motion meets the next. Throws std::runtime_error if the run has
/// no motion there.
Extremes extremes(const Run &run, std::size_t mass, const Real &from, const Real &to);

/// How hard a mass is pressed into its stop where that is least inside its sticking phases that
/// begin after `from`: the local minimum nearest to zero. Throws std::runtime_error if there is
/// none.
Real least_pressing(const Scene &scene, const Run &run, std::size_t stop, const Real &from);

}  // namespace vibro_impact_reference
