// The state of a motion as the analysis takes it, from a moment of a run or by its coordinates.
#pragma once

#include "eigen_views.hpp"
#include "vibro_impact/analysis/hold_force.hpp"

namespace vibro_impact {

inline MotionState state_at(const Moment &moment, const Held &held) {
  MotionState at{moment.instant, {}, {}, held};
  for (int mass = 1; mass <= moment.masses(); ++mass) {
    at.displacement.push_back(moment.displacement(mass));
    at.velocity.push_back(moment.velocity(mass));
  }
  return at;
}

// Row `row` of (x_1 .. x_N, x_1' .. x_N').
inline double &coordinate(MotionState &at, std::size_t row) {
  const std::size_t n = at.held.size();
  return row < n ? at.displacement[row] : at.velocity[row - n];
}

inline bool holds(const Stop &stop, const Held &held) {
  return held[static_cast<std::size_t>(stop.mass - 1)] == static_cast<signed char>(stop.side);
}

// Held masses at rest at their stops, which may not be quite where they were.
inline void hold_at_stops(const Scene &scene, MotionState &at) {
  for (const Stop &stop : scene.stops) {
    if (!holds(stop, at.held)) continue;
    const auto i = static_cast<std::size_t>(stop.mass - 1);
    at.displacement[i] = stop.position;
    at.velocity[i] = 0.0;
  }
}

// (x', x'') of all masses; the stops do not enter.
inline Eigen::VectorXd vector_field(const Scene &scene, const MotionState &at) {
  const std::vector<double> a = acceleration(scene, at);
  Eigen::VectorXd f(2 * static_cast<Eigen::Index>(a.size()));
  f << view(at.velocity), view(a);
  return f;
}

}  // namespace vibro_impact
