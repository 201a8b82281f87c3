// Orbits that just touch: the hold force inside a sticking phase zero (multi-sliding), the gap of a
// mass that flies past its stop zero (grazing).
#pragma once

#include "orbit.hpp"

#include <utility>
#include <vector>

namespace vibro_impact_reference {

/// The last coordinate of points, as a polynomial in the value that goes with each, at value zero.
inline Real at_zero(const std::vector<std::pair<Real, Real>> &points) {
  Real x = 0;
  for (const auto &point : points) {
    Real weight = 1;
    for (const auto &other : points)
      if (other.first != point.first) weight *= other.first / (other.first - point.first);
    x += weight * point.second;
  }
  return x;
}

/// The frequency near that of the scene at which the condition of the orbit is zero: frequencies at
/// which it has ever smaller positive values, by polynomial continuation to zero. An orbit beyond
/// it is another one, with a phase of sticking or an impact that this one does not have; on this
/// side everything is smooth. The error: what the last point changes.
inline Located touching_frequency(Scene scene, int settling, const Condition &condition) {
  const Resolution resolution = resolution_down_to(Real("1e-22"));
  SoughtOrbit orbit = orbit_from_rest(std::move(scene), 1, settling, resolution);
  SquareMatrix inverse;
  std::vector<std::pair<Real, Real>> points;
  Located located{0, 1};
  for (const char *target : {"1e-6", "1e-10", "1e-14", "1e-18", "1e-22"}) {
    const Real value(target);
    const Real step = solve_orbit(orbit, inverse, resolution, condition, value, Real("1e-33"));
    points.push_back({value, orbit.unknowns.back()});
    const Real zero = at_zero(points);
    located = {zero, abs(zero - located.value) + step};
  }
  return located;
}

}  // namespace vibro_impact_reference
