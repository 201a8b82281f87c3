// What independent runs say of the points of a curve of bifurcations.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "curve_starts.hpp"

namespace vibro_impact::figures {

// How often the mass sticks, or whether it hits (grazing), on the orbit at another place beside a
// point of the curve, by runs that neither look at the force nor resolve the chatter.
inline int count_at(const BifurcationCurve &curve, const CurvePoint &point, const PlanePoint &at) {
  const Scene scene = curve.at(at);
  MotionState seed = point.state;
  seed.instant.phase *= curve.at(point.at).omega / scene.omega;
  const bool hits = curve.what == Bifurcation::grazing;
  // Beyond a grazing impacts may come now and then only.
  const int periods = hits ? 60 : curve.periods;
  const MotionState orbit = orbit_near(scene, seed, curve.periods, 100).value();
  const auto events = events_after(scene, orbit, periods);
  const auto count = std::count_if(events.begin(), events.end(), [&](const Event &event) {
    return event.stop == curve.stop && event.kind == (hits ? EventKind::impact : EventKind::stick);
  });
  return hits ? count > 0 : static_cast<int>(count);
}

// How far from a point of a curve, across it and in units of the box, this count changes: by
// bisection within 1e-11 or, where the counts at both ends agree, ever farther, up to 1e-7. (Other
// changes may be as near: two chatters that hardly fail to complete lie between each other's, and
// beside an unstable orbit the count is soon another's.) Nothing where they agree there, too.
inline std::optional<double> distance_by_counting(const BifurcationCurve &curve,
                                                  const CurvePoint &point, const PlaneBox &box) {
  const PlanePoint across = box.across(point.gradient);
  const auto count = [&](double s) { return count_at(curve, point, moved(point.at, across, s)); };
  for (const double reach : {1e-11, 1e-10, 1e-9, 1e-7}) {
    if (count(-reach) == count(reach)) continue;
    const CountJump change = bisect(count, -reach, reach, std::min(1e-12, 0.01 * reach));
    return 0.5 * std::abs(change.below + change.above);
  }
  return std::nullopt;
}

// How far a place is from a curve, across it and in units of the box, asked of the corrector from
// the nearest of its points; nothing where the curve with the orbit of that point is not there.
inline std::optional<double> distance_to(const BifurcationCurve &curve,
                                         const std::vector<CurvePoint> &points,
                                         const PlanePoint &at, const PlaneBox &box, double near) {
  const auto nearest =
      std::min_element(points.begin(), points.end(), [&](const auto &a, const auto &b) {
        return box.distance(a.at, at) < box.distance(b.at, at);
      });
  if (nearest == points.end() || box.distance(nearest->at, at) > near) return std::nullopt;
  const auto found = corrector_of(curve)(at, box.across(nearest->gradient), *nearest);
  if (!found || found->events != nearest->events || found->period != nearest->period)
    return std::nullopt;
  return box.distance(found->at, at);
}

}  // namespace vibro_impact::figures
