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

inline bool moves(std::size_t mass, const Flow &flow) {
  return std::find(flow.free.begin(), flow.free.end(), mass) != flow.free.end();
}

inline void extend_extremes(Extremes &extremes, const Flow &flow, const Real &duration,
                            const Real &from, const Real &to) {
  const Real begin = std::max<Real>(Real(0), from - flow.start_time);
  const Real end = std::min<Real>(duration, to - flow.start_time);
  if (begin >= end) return;
  const auto include = [&](const Real &tau) {
    const Motion motion = motion_at(flow, tau);
    if (extremes.lowest.empty())
      extremes = {motion.x, motion.x, Vector(motion.x.size(), flow.start_time + tau)};
    for (std::size_t p = 0; p < motion.x.size(); ++p) {
      extremes.lowest[p] = std::min<Real>(extremes.lowest[p], motion.x[p]);
      if (motion.x[p] <= extremes.highest[p]) continue;
      extremes.highest[p] = motion.x[p];
      extremes.highest_at[p] = flow.start_time + tau;
    }
  };
  include(begin);
  for (const std::size_t p : flow.free)
    each_turn(
        flow, begin, end, [&](const Real &tau) { return motion_at(flow, tau).v[p]; }, include);
  include(end);
}

/// The extremes of a motion over [from, to]: at zeros of the velocity (sampled, then bisected) or
/// where one piece of motion meets the next. `held`: only while this mass rests on its stop.
inline Extremes extremes(const Run &run, const Real &from, const Real &to,
                         std::optional<std::size_t> held = {}) {
  Extremes result;
  for (const Piece &piece : run.pieces)
    if (!held || !moves(*held, piece.flow))
      extend_extremes(result, piece.flow, piece.duration, from, to);
  return result;
}

/// How hard a mass is pressed into its stop where that is least inside its sticking phases that
/// begin after `from`: the local minimum nearest to zero. Throws std::runtime_error if there is
/// none.
inline Real least_pressing(const Scene &scene, const Run &run, std::size_t stop, const Real &from) {
  std::optional<Real> least;
  for (const auto &[flow, duration, events_before] : run.pieces) {
    if (moves(scene.stops[stop].mass, flow) || flow.start_time < from) continue;
    const auto pressing = [&, &held = flow](const Real &tau) {
      return pressing_signal(scene.chain, scene.stops[stop], motion_at(held, tau));
    };
    each_turn(
        flow, Real(0), duration, [&](const Real &tau) { return pressing(tau).rate; },
        [&](const Real &tau) {
          const Signal at_turn = pressing(tau);
          if (at_turn.curvature > 0 && (!least || abs(at_turn.value) < abs(*least)))
            least = at_turn.value;
        });
  }
  if (!least) throw std::runtime_error("no least force in a sticking phase");
  return *least;
}

}  // namespace vibro_impact_reference
