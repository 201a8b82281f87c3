// The points at which a motion or a hold force comes closest to a given value.
#pragma once

#include "event_driven.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <stdexcept>

namespace vibro_impact_reference {

/// Calls found(tau) where `rate_at`, sampled along the flow, changes its sign in [begin, end].
template <class RateAt, class Found>
void each_turn(const Flow &flow, const Real &begin, const Real &end, const RateAt &rate_at,
               const Found &found) {
  const Real step = sampling_step(flow, Real(0));
  bool rising = rate_at(begin) > 0;
  for (Real a = begin; a < end; a += step) {
    const Real b = std::min<Real>(a + step, end);
    if (rising == (rate_at(b) > 0)) continue;
    found(
        bisect([&](const Real &tau) { return (rate_at(tau) > 0) == rising; }, a, b, Real("1e-36")));
    rising = !rising;
  }
}

/// Smallest and largest position of each mass, and when the largest is met first.
struct Extremes {
  Vector lowest, highest, highest_at;
};

/// The extremes of a motion over [from, to]: at zeros of the velocity (sampled, then bisected) or
/// where one piece of motion meets the next.
Extremes extremes(const Run &run, const Real &from, const Real &to);

/// How hard a mass is pressed into its stop where that is least inside its sticking phases that
/// begin after `from`: the local minimum nearest to zero. Throws std::runtime_error if there is
/// none.
Real least_pressing(const Scene &scene, const Run &run, std::size_t stop, const Real &from);

}  // namespace vibro_impact_reference
