// Where a motion, and a hold force, come closest to something: observers of a simulation.
#pragma once

#include "event_driven.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>

namespace vibro_impact_reference {

/// Smallest and largest position of each mass over [from, to], and when the largest is met first,
/// filled by an observer of simulate.
/// Extremes are at zeros of the velocity (sampled, then bisected) or where one piece of motion
/// meets the next.
struct Extremes {
  Vector lowest, highest, highest_at;
};

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

/// Largest interior local maximum of the hold force on a mass (towards letting go: of -|F|, with
/// the force's own sign for a lower stop) among the sticking phases that lie after `from`; none if
/// the force has no such maximum there.
inline void extend_closest_hold(std::optional<Real> &closest, const Scene &scene,
                                std::size_t stop_index, const Flow &flow, const Real &duration,
                                const Real &from) {
  const Stop &stop = scene.stops[stop_index];
  const bool free = std::find(flow.free.begin(), flow.free.end(), stop.mass) != flow.free.end();
  if (free || flow.start_time < from) return;
  const auto pressing = [&](const Real &tau) {
    return pressing_signal(scene.chain, stop, motion_at(flow, tau));
  };
  const Real step = 2 * acos(Real(-1)) / fastest_rate_at(flow, Real(0)) / 128;
  Signal at_a = pressing(Real(0));
  for (Real a = 0; a < duration;) {
    const Real b = std::min<Real>(a + step, duration);
    const Signal at_b = pressing(b);
    if (at_a.rate < 0 && at_b.rate > 0) {  // the pressing is least here
      const Real turn =
          bisect([&](const Real &tau) { return pressing(tau).rate < 0; }, a, b, small(36));
      const Real force = side_sign(stop) * pressing(turn).value;
      if (!closest || abs(force) < abs(*closest)) closest = force;
    }
    at_a = at_b;
    a = b;
  }
}

}  // namespace vibro_impact_reference
