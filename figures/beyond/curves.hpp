// What independent runs say of the points of a curve of bifurcations.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "curve_starts.hpp"

namespace vibro_impact::figures {

// The scene beside a point of a curve: across it, in units of the box; and the motion of the point
// there.
struct BesideCurve {
  Scene scene;
  MotionState seed;
};
inline BesideCurve beside(const BifurcationCurve &curve, const CurvePoint &point,
                          const PlaneBox &box, double across) {
  const double width = box.x_to - box.x_from, height = box.y_to - box.y_from;
  const double gx = point.gradient.x * width, gy = point.gradient.y * height,
               s = across / std::hypot(gx, gy);
  BesideCurve found{curve.at({point.at.x + s * width * gx, point.at.y + s * height * gy}),
                    point.state};
  found.seed.instant.phase *= curve.at(point.at).omega / found.scene.omega;
  return found;
}

// How often the mass sticks on the orbit beside, or whether it hits (grazing), by runs that neither
// look at the force nor resolve the chatter; of a period doubling, how many Floquet multipliers of
// the stroboscopic map lie outside the unit circle.
inline int count_beside(const BifurcationCurve &curve, const BesideCurve &at) {
  const auto &[scene, seed] = at;
  if (curve.what == Bifurcation::period_doubling) {
    const PeriodicOrbit orbit =
        find_periodic_orbit(scene, at_quiet_phase(scene, seed), curve.periods);
    if (!orbit.converged) return -1;
    return static_cast<int>(
        std::count_if(orbit.multipliers.begin(), orbit.multipliers.end(),
                      [](const auto &multiplier) { return std::abs(multiplier) > 1.0; }));
  }
  const EventKind kind = curve.what == Bifurcation::grazing ? EventKind::impact : EventKind::stick;
  EventRecorder recorder;
  // Beyond a grazing impacts may come now and then only.
  const int periods = kind == EventKind::impact ? 60 : curve.periods;
  stroboscopic_map(scene, orbit_near(scene, seed, curve.periods, {}, 100), periods, {}, recorder);
  const auto count = std::count_if(
      recorder.events.begin(), recorder.events.end(),
      [&](const Event &event) { return event.kind == kind && event.stop == curve.stop; });
  return kind == EventKind::impact ? count > 0 : static_cast<int>(count);
}

// How far from a point of a curve, across it and in units of the box, this count changes: by
// bisection within 1e-11 or, where the counts at both ends agree, ever farther, up to 1e-7. (Other
// changes may be as near: two chatters that hardly fail to complete lie between each other's, and
// beside an unstable orbit the count is soon another's.) Nothing where they agree there, too, and
// for a fold, on one side of which there is no orbit to count on.
inline std::optional<double> distance_by_counting(const BifurcationCurve &curve,
                                                  const CurvePoint &point, const PlaneBox &box) {
  if (curve.what == Bifurcation::fold) return std::nullopt;
  const auto count = [&](double s) { return count_beside(curve, beside(curve, point, box, s)); };
  for (const double reach : {1e-11, 1e-10, 1e-9, 1e-7}) {
    if (count(-reach) == count(reach)) continue;
    const Change change = bisect(count, -reach, reach, std::min(1e-12, 0.01 * reach));
    return 0.5 * std::abs(change.below + change.above);
  }
  return std::nullopt;
}

// A Floquet multiplier of the stroboscopic map: the largest by modulus beside the curve, where the
// phase is whole or the chatter completes; on a period doubling or a fold the one nearest to -1
// or 1.
inline double multiplier_at(const BifurcationCurve &curve, const CurvePoint &point,
                            const PlaneBox &box) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const bool doubling = curve.what == Bifurcation::period_doubling;
  if (doubling || curve.what == Bifurcation::fold) {
    const Scene scene = curve.at(point.at);
    const MotionState at = at_quiet_phase(scene, point.state);
    const Matrix map = stroboscopic_map_and_derivative(scene, at, curve.periods).derivative;
    const double due = doubling ? -1.0 : 1.0;
    double nearest = nan;
    for (const auto &multiplier : floquet_multipliers(map, at.held))
      if (!(std::abs(nearest - due) <= std::abs(multiplier - due))) nearest = multiplier.real();
    return nearest;
  }
  const auto [scene, seed] = beside(curve, point, box, 1e-6);
  const PeriodicOrbit orbit = find_periodic_orbit(scene, seed, curve.periods);
  return orbit.converged && !orbit.multipliers.empty() ? orbit.multipliers.front().real() : nan;
}

}  // namespace vibro_impact::figures
