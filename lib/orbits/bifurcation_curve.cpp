#include "vibro_impact/bifurcation_curve.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "fits.hpp"
#include "vibro_impact/border_orbit.hpp"
#include "vibro_impact/multi_sliding.hpp"
#include "vibro_impact/settle.hpp"

namespace vibro_impact {

namespace {

// What is zero on the curve at a point beside it.
struct Reading {
  double value = 0.0;
  PlanePoint gradient;
  MotionState state;
  double time = 0.0;
};

RunOptions every_impact() {
  RunOptions options;
  options.resolve_chatter = 0.0;
  return options;
}

// The time at the same angle of the forcing in another scene.
double same_angle(double time, const Scene &from, const Scene &to) {
  return time * from.omega / to.omega;
}

// The orbit from a neighbouring motion of scene `from`: by Newton's method, or where that fails,
// from the motion followed for a while.
std::optional<PeriodicOrbit> orbit_in(const Scene &scene, const Scene &from, MotionState seed,
                                      int periods, const RunOptions &run) {
  seed.instant.phase = same_angle(seed.instant.phase, from, scene);
  NewtonOptions options;
  options.run = run;
  options.tolerance = 1e-12;
  options.max_iterations = 12;
  PeriodicOrbit orbit = find_periodic_orbit(scene, seed, periods, options);
  if (!orbit.converged)
    orbit = find_periodic_orbit(scene, orbit_near(scene, seed, periods, run, 40), periods, options);
  if (!orbit.converged) return std::nullopt;
  return orbit;
}

// How often the mass of the stop sticks (multi-sliding) or hits (grazing): another number is
// another side of the curve.
int count_of(const BifurcationCurve &curve, const Scene &scene, const MotionState &at) {
  EventMarks marks;
  marks.from = at.instant;
  stroboscopic_map(scene, at, curve.periods, {}, marks);
  const EventCounts counts = counts_of(scene, marks.marks, curve.periods, dual_sticking(at.held));
  const auto mass = static_cast<std::size_t>(scene.stops[curve.stop].mass - 1);
  return curve.what == Bifurcation::grazing ? counts.impacts[mass] : counts.sticks[mass];
}

// The least pressing force, or gap; nothing where the orbit has another count than `count`, unless
// that is negative.
std::optional<Reading> least_value(const BifurcationCurve &curve, const PlanePoint &at,
                                   const Scene &from, const MotionState &seed, int count) {
  const Scene scene = curve.at(at);
  const auto orbit = orbit_in(scene, from, seed, curve.periods, {});
  if (!orbit || (count >= 0 && count_of(curve, scene, orbit->state) != count)) return std::nullopt;
  const OrbitChange change = orbit_change(scene, *orbit, {curve.x, curve.y});
  const Stop &stop = scene.stops[curve.stop];
  const auto least = curve.what == Bifurcation::grazing
                         ? least_gap_change(scene, *orbit, change, stop)
                         : least_pressing_force_change(scene, *orbit, change, stop);
  if (!least || !(least->value > 0.0)) return std::nullopt;
  return Reading{least->value, {least->by[0], least->by[1]}, orbit->state, 0.0};
}

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

PlanePoint moved(const PlanePoint &from, const PlanePoint &direction, double by) {
  return {from.x + by * direction.x, from.y + by * direction.y};
}

double along(const PlanePoint &gradient, const PlanePoint &direction) {
  return gradient.x * direction.x + gradient.y * direction.y;
}

// A reading at `read`, very near, made a point of the curve, at a section far from events.
CurvePoint point_from(const BifurcationCurve &curve, const PlanePoint &at, const PlanePoint &read,
                      const Reading &reading, double error) {
  CurvePoint point{at, reading.gradient, error, reading.state, reading.time};
  const Scene scene = curve.at(read);
  const Clock clock(scene.omega);
  point.state = at_quiet_phase(scene, reading.state);
  double later = point.state.instant.phase - reading.state.instant.phase;
  if (later < 0.0) later += clock.period;
  const double period = curve.periods * clock.period;
  point.time -= later;
  if (point.time < 0.0) point.time += period;
  return point;
}

// From the side where the value is positive, the way to it divided by some 30 each time.
std::optional<CurvePoint> from_one_side(const BifurcationCurve &curve, const PlanePoint &guess,
                                        const PlanePoint &across, const Scene &from,
                                        const MotionState &start, double side, int count) {
  constexpr double near = 1e-8, farthest = 0.02;
  double s = 0.0;
  std::optional<Reading> reading = least_value(curve, guess, from, start, count);
  for (double margin = 1e-6; !reading && margin < farthest; margin *= 4.0) {
    s = side * margin;
    reading = least_value(curve, moved(guess, across, s), from, start, count);
  }
  for (int step = 0; reading && step < 30; ++step) {
    const double slope = along(reading->gradient, across), way = reading->value / slope;
    if (!std::isfinite(way)) return std::nullopt;
    if (std::abs(way) <= near) {
      CurvePoint point = point_from(curve, moved(guess, across, s - way), moved(guess, across, s),
                                    *reading, way * way);
      const Scene here = curve.at(moved(guess, across, s));
      point.count = count_of(curve, here, reading->state);
      const Stop &stop = here.stops[curve.stop];
      const auto least = curve.what == Bifurcation::grazing
                             ? where_gap_is_least(here, point.state, stop)
                             : where_pressing_force_is_least(here, point.state, stop);
      if (least) point.time = elapsed(point.state.instant, least->at.instant, Clock(here.omega));
      return point;
    }
    const Scene here = curve.at(moved(guess, across, s));
    std::optional<Reading> next;
    double part = 1.0 - std::max(1.0 / 30.0, 0.5 * near / std::abs(way));
    for (int halving = 0; halving < 6 && !next; ++halving, part /= 2.0) {
      next = least_value(curve, moved(guess, across, s - part * way), here, reading->state, count);
      if (next) s -= part * way;
    }
    reading = next;
  }
  return std::nullopt;
}

// Newton's method in the excess with the depth growing: the zero of one depth lies in the window of
// the next. The border lies between where the chatter completes and where it does not; `side` is
// the direction of the former, `reach` the first step that looks for the other.
std::optional<CurvePoint> by_depth(const BifurcationCurve &curve, const PlanePoint &guess,
                                   const PlanePoint &across, Scene from, MotionState seed,
                                   double time, double side, double reach) {
  constexpr std::size_t first = 5, deepest = 90;
  constexpr double farthest = 0.05, enough = 2e-14;
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  double s = 0.0, complete = unknown, incomplete = unknown;
  double last_step = std::numeric_limits<double>::infinity();
  std::optional<Reading> best;
  double best_s = 0.0;
  std::size_t depth = first;
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

}  // namespace

const char *name(Bifurcation bifurcation) {
  if (bifurcation == Bifurcation::grazing) return "grazing";
  return bifurcation == Bifurcation::border_orbit ? "border orbit" : "multi-sliding";
}

Scene BifurcationCurve::at(const PlanePoint &point) const {
  return with(with(scene, x, point.x), y, point.y);
}

Corrector corrector_of(const BifurcationCurve &curve) {
  return [curve](const PlanePoint &guess, const PlanePoint &across,
                 const CurvePoint &neighbour) -> std::optional<CurvePoint> {
    const Scene from = curve.at(neighbour.at);
    try {
      const double side = along(neighbour.gradient, across) > 0.0 ? 1.0 : -1.0;
      if (curve.what == Bifurcation::border_orbit)
        return by_depth(curve, guess, across, from, neighbour.state, neighbour.time, side, 2e-4);
      return from_one_side(curve, guess, across, from, neighbour.state, side, neighbour.count);
    } catch (const std::exception &) {  // outside the scene's limits, a run given up, a fold
      return std::nullopt;
    }
  };
}

std::optional<CurvePoint> point_of(const BifurcationCurve &curve, const PlanePoint &guess,
                                   const PlanePoint &across, const MotionState &seed, double time) {
  const Scene from = curve.at(guess);
  if (curve.what == Bifurcation::border_orbit)
    return by_depth(curve, guess, across, from, seed, time, 1.0, 1e-6);
  return from_one_side(curve, guess, across, from, seed, 1.0, -1);
}

}  // namespace vibro_impact
