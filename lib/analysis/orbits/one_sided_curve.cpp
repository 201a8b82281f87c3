#include <algorithm>
#include <cmath>

#include "curve_kinds.hpp"
#include "vibro_impact/analysis/multi_sliding.hpp"
#include "vibro_impact/analysis/settle.hpp"

namespace vibro_impact {

namespace {

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
std::optional<Condition> least_value(const BifurcationCurve &curve, const PlanePoint &at,
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
  return Condition{least->value, {least->by[0], least->by[1]}, orbit->state, 0.0};
}

}  // namespace

std::optional<CurvePoint> from_one_side(const BifurcationCurve &curve, const PlanePoint &guess,
                                        const PlanePoint &across, const Scene &from,
                                        const MotionState &start, double side, int count) {
  constexpr double near = 1e-10, farthest = 2e-3;
  double s = 0.0;
  std::optional<Condition> reading = least_value(curve, guess, from, start, count);
  for (double margin = 1e-9; !reading && margin < farthest; margin *= 8.0) {
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
    std::optional<Condition> next;
    double part = 1.0 - std::max(1.0 / 30.0, 0.5 * near / std::abs(way));
    for (int halving = 0; halving < 6 && !next; ++halving, part /= 2.0) {
      next = least_value(curve, moved(guess, across, s - part * way), here, reading->state, count);
      if (next) s -= part * way;
    }
    reading = next;
  }
  return std::nullopt;
}

}  // namespace vibro_impact
