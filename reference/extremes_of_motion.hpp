// Where a motion, and a hold force, come closest to something.
#pragma once

#include "event_driven.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <stdexcept>

namespace vibro_impact_reference {

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
  const auto include = [&](const Motion &motion, const Real &tau) {
    if (extremes.lowest.empty())
      extremes = {motion.x, motion.x, Vector(motion.x.size(), flow.start_time + tau)};
    for (std::size_t p = 0; p < motion.x.size(); ++p) {
      extremes.lowest[p] = std::min<Real>(extremes.lowest[p], motion.x[p]);
      if (motion.x[p] <= extremes.highest[p]) continue;
      extremes.highest[p] = motion.x[p];
      extremes.highest_at[p] = flow.start_time + tau;
    }
  };
  const Real step = 2 * acos(Real(-1)) / fastest_rate_at(flow, Real(0)) / 128;
  Motion at_a = motion_at(flow, begin);
  include(at_a, begin);
  for (Real a = begin; a < end;) {
    const Real b = std::min<Real>(a + step, end);
    const Motion at_b = motion_at(flow, b);
    include(at_b, b);
    for (const std::size_t p : flow.free) {
      const bool positive = at_a.v[p] > 0;
      if (positive == (at_b.v[p] > 0)) continue;
      const Real turn =
          bisect([&](const Real &tau) { return (motion_at(flow, tau).v[p] > 0) == positive; }, a, b,
                 small(36));
      include(motion_at(flow, turn), turn);
    }
    at_a = at_b;
    a = b;
  }
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
    const Real step = 2 * acos(Real(-1)) / fastest_rate_at(flow, Real(0)) / 128;
    Signal at_a = pressing(Real(0));
    for (Real a = 0; a < duration;) {
      const Real b = std::min<Real>(a + step, duration);
      const Signal at_b = pressing(b);
      if (at_a.rate < 0 && at_b.rate > 0) {
        const Real turn =
            bisect([&](const Real &tau) { return pressing(tau).rate < 0; }, a, b, small(36));
        const Real value = pressing(turn).value;
        if (!least || abs(value) < abs(*least)) least = value;
      }
      at_a = at_b;
      a = b;
    }
  }
  if (!least) throw std::runtime_error("no least force in a sticking phase");
  return *least;
}

}  // namespace vibro_impact_reference
