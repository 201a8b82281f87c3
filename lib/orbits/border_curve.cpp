#include <algorithm>
#include <cmath>
#include <limits>

#include "curve_kinds.hpp"
#include "fits.hpp"
#include "vibro_impact/border_orbit.hpp"

namespace vibro_impact {

namespace {

// The impacts of a chatter, numbers among the events, and the time it ends after the section.
struct ChatterFound {
  std::vector<std::size_t> impacts;
  double end = 0.0;
  bool complete = false;
};

// That which ends nearest to `time`, and not farther from it than `window`.
std::optional<ChatterFound> chatter_near(const std::vector<EventChange> &events, std::size_t stop,
                                         double start, double time, double window) {
  std::optional<ChatterFound> nearest, now;
  const auto close = [&](bool complete) {
    if (now && std::abs(now->end - time) < window &&
        (!nearest || std::abs(now->end - time) < std::abs(nearest->end - time))) {
      nearest = now;
      nearest->complete = complete;
    }
    now.reset();
  };
  for (std::size_t i = 0; i < events.size(); ++i) {
    const Event &event = events[i].event;
    if (event.stop != stop) continue;
    if (event.kind != EventKind::impact) {
      close(event.kind == EventKind::stick);
      continue;
    }
    if (event.falling == 0) close(false);
    if (!now) now.emplace();
    now->impacts.push_back(i);
    now->end = event.time - start;
  }
  close(false);
  return nearest;
}

// The excess of a chatter at a depth, and whether the chatter completes; no value where it has no
// impact so deep.
struct Excess {
  Reading reading;
  bool complete = false, deep = false;
};

std::optional<Excess> excess_at(const BifurcationCurve &curve, const PlanePoint &at,
                                const Scene &from, const MotionState &seed, double time,
                                std::size_t depth) {
  const Scene scene = curve.at(at);
  const auto orbit = orbit_in(scene, from, seed, curve.periods, every_impact());
  if (!orbit) return std::nullopt;
  const OrbitChange change = orbit_change(scene, *orbit, {curve.x, curve.y}, every_impact());
  const Clock clock(scene.omega);
  const double start = time_of(orbit->state.instant, clock), due = same_angle(time, from, scene);
  const auto chatter = chatter_near(change.events, curve.stop, start, due, clock.period / 16.0);
  if (!chatter) return Excess{{0.0, {}, orbit->state, due}};
  const bool deep = chatter->impacts.size() >= depth + 2;
  Excess found{{0.0, {}, orbit->state, chatter->complete || deep ? chatter->end : due},
               chatter->complete};
  if (!deep) return found;
  // Impacts of other masses come between: the two are looked at by themselves.
  const OrbitChange pair{
      change.by,
      {},
      {change.events[chatter->impacts[depth]], change.events[chatter->impacts[depth + 1]]}};
  const ValueChange excess = border_excess_change(scene, pair, 0);
  found.reading.value = excess.value;
  found.reading.gradient = {excess.by[0], excess.by[1]};
  found.deep = std::isfinite(excess.by[0]) && std::isfinite(excess.by[1]);
  return found;
}

}  // namespace

std::optional<CurvePoint> by_depth(const BifurcationCurve &curve, const PlanePoint &guess,
                                   const PlanePoint &across, Scene from, MotionState seed,
                                   double time, double side, double reach) {
  constexpr std::size_t deepest = 90;
  constexpr double farthest = 0.05, enough = 2e-14;
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  double s = 0.0, complete = unknown, incomplete = unknown;
  double last_step = std::numeric_limits<double>::infinity();
  std::optional<Reading> best;
  double best_s = 0.0;
  // Not as deep where the speeds fall fast: they must not fall below rounding.
  const double r = law_of(from, from.stops[curve.stop]).at_rest();
  std::size_t depth = static_cast<std::size_t>(
      std::clamp(std::log(1e-4) / std::log(border_chatter(r).speed_ratio), 1.0, 5.0));
  for (int iteration = 0; iteration < 70 && depth <= deepest; ++iteration) {
    const auto found = excess_at(curve, moved(guess, across, s), from, seed, time, depth);
    if (!found) {  // no orbit: nearer to where there was one
      if (!std::isfinite(complete) || s == complete) return std::nullopt;
      s = 0.5 * (s + complete);
      continue;
    }
    (found->complete ? complete : incomplete) = s;
    from = curve.at(moved(guess, across, s));
    seed = found->reading.state;
    time = found->reading.time;
    double next = unknown;
    if (found->deep) {
      best = found->reading;
      best_s = s;
      next = s - best->value / along(best->gradient, across);
    }
    const double width = std::abs(complete - incomplete);
    if (!std::isfinite(width)) {  // not between yet
      if (!(std::abs(next - s) <= reach)) next = s + (found->complete ? -side : side) * reach;
      reach *= 2.0;
    } else if (!((next - complete) * (next - incomplete) < 0.0)) {
      next = 0.5 * (complete + incomplete);
    }
    if (std::abs(next) > farthest) return std::nullopt;
    const double step = std::abs(next - s);
    s = next;
    if (width < enough || (depth >= 10 && std::max(step, last_step) < enough)) break;
    last_step = step;
    if (found->deep) depth += step < 1e-3 ? 2 : 1;
  }
  const double error = std::fmin(last_step, std::abs(complete - incomplete));
  if (!best || !(error < 1e-11)) return std::nullopt;
  return point_from(curve, moved(guess, across, s), moved(guess, across, best_s), *best,
                    std::max(error, 1e-16));
}

}  // namespace vibro_impact
