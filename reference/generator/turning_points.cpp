#include "turning_points.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>

namespace vibro_impact_reference {

namespace {

bool moves(std::size_t mass, const Flow &flow) {
  return std::find(flow.free.begin(), flow.free.end(), mass) != flow.free.end();
}

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

}  // namespace

Extremes extremes(const Run &run, std::size_t mass, const Real &from, const Real &to) {
  std::optional<Extremes> found;
  for (const Piece &piece : run.pieces) {
    const Flow &flow = piece.flow;
    const Real begin = std::max<Real>(Real(0), from - flow.start_time);
    const Real end = std::min<Real>(piece.duration, to - flow.start_time);
    if (begin >= end) continue;
    const auto include = [&](const Real &tau) {
      const Real x = motion_at(flow, tau).x[mass], time = flow.start_time + tau;
      if (!found) found = {x, x, time};
      found->lowest = std::min(found->lowest, x);
      if (x <= found->highest) return;
      found->highest = x;
      found->highest_at = time;
    };
    include(begin);
    if (moves(mass, flow))
      each_turn(
          flow, begin, end, [&](const Real &tau) { return motion_at(flow, tau).v[mass]; }, include);
    include(end);
  }
  if (!found) throw std::runtime_error("the run has no motion in that interval");
  return *found;
}

Real least_pressing(const Scene &scene, const Run &run, std::size_t stop, const Real &from) {
  std::optional<Real> least;
  for (const Piece &piece : run.pieces) {
    const Flow &flow = piece.flow;
    if (moves(scene.stops[stop].mass, flow) || flow.start_time < from) continue;
    const auto pressing = [&](const Real &tau) {
      return pressing_signal(scene, scene.stops[stop], motion_at(flow, tau));
    };
    each_turn(
        flow, Real(0), piece.duration, [&](const Real &tau) { return pressing(tau).rate; },
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
