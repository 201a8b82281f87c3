#include <cmath>
#include <limits>

#include "curve_kinds.hpp"
#include "impact_section.hpp"

namespace vibro_impact {

namespace {

ImpactFamily family_at(const BifurcationCurve &curve, double y) {
  return {with(curve.scene, curve.y, y), curve.x, curve.stop, curve.periods};
}

double value_of(const BifurcationCurve &curve, const ImpactOrbit &orbit) {
  return curve.what == Bifurcation::fold ? orbit.parameter_by_speed : orbit.doubling;
}

// The orbit at (v, y), and how x and what is zero change with them: x by v as the family has it,
// the others by central differences, which only slow Newton's method down by their error.
struct Local {
  ImpactOrbit orbit;
  double value, x_v, x_y, value_v, value_y;
};

std::optional<Local> local_at(const BifurcationCurve &curve, double v, double y,
                              const ImpactOrbit &near) {
  constexpr double h = 1e-5;
  const auto orbit = impact_orbit(family_at(curve, y), near, v);
  if (!orbit) return std::nullopt;
  const auto faster = impact_orbit(family_at(curve, y), *orbit, v + h),
             slower = impact_orbit(family_at(curve, y), *orbit, v - h),
             above = impact_orbit(family_at(curve, y + h), *orbit, v),
             below = impact_orbit(family_at(curve, y - h), *orbit, v);
  if (!faster || !slower || !above || !below) return std::nullopt;
  return Local{*orbit,
               value_of(curve, *orbit),
               orbit->parameter_by_speed,
               (above->parameter - below->parameter) / (2.0 * h),
               (value_of(curve, *faster) - value_of(curve, *slower)) / (2.0 * h),
               (value_of(curve, *above) - value_of(curve, *below)) / (2.0 * h)};
}

}  // namespace

ImpactOrbit impact_orbit_at(const BifurcationCurve &curve, const CurvePoint &point) {
  ImpactOrbit orbit;
  orbit.speed = point.speed;
  orbit.parameter = point.at.x;
  orbit.state = point.state;
  const Scene scene = curve.at(point.at);
  const double begin = point.state.instant.phase,
               whole = time_after(scene, point.state, curve.periods) - begin;
  OtherEvents others{curve.stop, begin, whole};
  simulate_from(scene, point.state, begin + whole * (1.0 - 1e-6), {}, others);
  orbit.first_other = others.first;
  orbit.last_other = others.last;
  return orbit;
}

std::optional<CurvePoint> by_speed(const BifurcationCurve &curve, const PlanePoint &guess,
                                   const PlanePoint &across, ImpactOrbit orbit) {
  double v = orbit.speed, s = 0.0, last = std::numeric_limits<double>::infinity();
  for (int iteration = 0; iteration < 15; ++iteration) {
    const PlanePoint at = moved(guess, across, s);
    const auto local = local_at(curve, v, at.y, orbit);
    if (!local) return std::nullopt;
    orbit = local->orbit;
    // x(v, y) is that of the line, and the value zero.
    const double off = orbit.parameter - at.x, by_s = local->x_y * across.y - across.x,
                 value_by_s = local->value_y * across.y;
    const double det = local->x_v * value_by_s - by_s * local->value_v;
    const double dv = (off * value_by_s - by_s * local->value) / det,
                 ds = (local->x_v * local->value - off * local->value_v) / det;
    const double step = std::abs(dv) + std::abs(ds);
    if (!std::isfinite(step) || step > 1.0) return std::nullopt;
    if (step < 1e-12 || (step < 1e-8 && step > 0.5 * last)) {
      if (!orbit.real) return std::nullopt;
      PlanePoint normal{local->value_v, local->x_v * local->value_y - local->x_y * local->value_v};
      return CurvePoint{at, normal, std::abs(ds) * std::hypot(across.x, across.y), orbit.state, 0.0,
                        -1, v};
    }
    last = step;
    v -= dv;
    s -= ds;
  }
  return std::nullopt;
}

}  // namespace vibro_impact
