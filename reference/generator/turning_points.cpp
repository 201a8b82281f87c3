#include "turning_points.hpp"

#include <algorithm>
#include <stdexcept>

namespace vibro_impact_reference {

namespace {

bool moves(std::size_t mass, const Flow &flow) {
  return std::find(flow.free.begin(), flow.free.end(), mass) != flow.free.end();
}

void extend_extremes(Extremes &extremes, const Flow &flow, const Real &duration, const Real &from,
                     const Real &to) {
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

}  // namespace

Extremes extremes(const Run &run, const Real &from, const Real &to) {
  Extremes result;
  for (const Piece &piece : run.pieces)
    extend_extremes(result, piece.flow, piece.duration, from, to);
  return result;
}

Real least_pressing(const Scene &scene, const Run &run, std::size_t stop, const Real &from) {
  std::optional<Real> least;
  for (const auto &[flow, duration, events_before] : run.pieces) {
    if (moves(scene.stops[stop].mass, flow) || flow.start_time < from) continue;
    const auto pressing = [&, &held = flow](const Real &tau) {
      return pressing_signal(scene, scene.stops[stop], motion_at(held, tau));
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
