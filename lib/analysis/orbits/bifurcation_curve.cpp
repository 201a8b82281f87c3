#include "vibro_impact/analysis/bifurcation_curve.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "curve_kinds.hpp"
#include "simulation/for_analysis.hpp"

namespace vibro_impact {

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

CurvePoint point_from(const BifurcationCurve &curve, const PlanePoint &at, const PlanePoint &read,
                      const Condition &reading, double error) {
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

double time_apart(const std::vector<Event> &events) {
  double least = std::numeric_limits<double>::infinity();
  const Event *last = nullptr;
  for (const Event &event : events) {
    if (event.kind != EventKind::impact) continue;
    if (last != nullptr && last->mass != event.mass)
      least = std::min(least, event.time - last->time);
    last = &event;
  }
  return least;
}

const char *name(Bifurcation bifurcation) {
  switch (bifurcation) {
    case Bifurcation::multi_sliding:
      return "multi-sliding";
    case Bifurcation::border_orbit:
      return "border orbit";
    case Bifurcation::grazing:
      return "grazing";
    case Bifurcation::period_doubling:
      return "period doubling";
    case Bifurcation::fold:
      break;
  }
  return "fold";
}

Scene BifurcationCurve::at(const PlanePoint &point) const {
  return with(with(scene, x, point.x), y, point.y);
}

Corrector corrector_of(const BifurcationCurve &curve) {
  return [curve](const PlanePoint &guess, const PlanePoint &across,
                 const CurvePoint &neighbour) -> std::optional<CurvePoint> {
    const Scene from = curve.at(neighbour.at);
    try {
      if (of_impacts(curve.what))
        return by_speed(curve, guess, across, impact_orbit_at(curve, neighbour));
      const double side = along(neighbour.gradient, across) > 0.0 ? 1.0 : -1.0;
      if (curve.what == Bifurcation::border_orbit)
        return by_held_chatter(curve, guess, across, neighbour);
      return from_one_side(curve, guess, across, from, neighbour.state, side, neighbour.count);
    } catch (const std::exception &) {  // outside the scene's limits, a run given up, a fold
      return std::nullopt;
    }
  };
}

std::optional<CurvePoint> point_of(const BifurcationCurve &curve, const PlanePoint &guess,
                                   const PlanePoint &across, const MotionState &seed, double time) {
  require(!of_impacts(curve.what), name(curve.what), ": is found from an orbit by impact speed");
  const Scene from = curve.at(guess);
  if (curve.what == Bifurcation::border_orbit)
    return by_held_chatter(curve, guess, across,
                           {.at = guess, .gradient = {}, .state = seed, .time = time});
  return from_one_side(curve, guess, across, from, seed, 1.0, -1);
}

std::optional<CurvePoint> point_of(const BifurcationCurve &curve, const ImpactOrbit &near) {
  require(of_impacts(curve.what), name(curve.what), ": is found from a motion near the orbit");
  return by_speed(curve, {near.parameter, get(curve.scene, curve.y)}, {1.0, 0.0}, near);
}

}  // namespace vibro_impact
