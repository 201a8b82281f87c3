// The periodic orbits of one impact of one mass before one stop, from a guess in words of the
// impact: its speed, its time and the parameter of the scene.
#pragma once

#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

#include "vibro_impact/analysis/analysis.hpp"
#include "vibro_impact/analysis/impact_family.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace vibro_impact::figures {

// The state right after an impact of the one mass at `time`, with `speed` before it.
inline MotionState after_impact(const Scene &scene, double time, double speed) {
  const Stop &stop = scene.stops.front();
  const double period = Clock(scene.omega).period;
  MotionState state = start_of(scene);
  state.instant = {0, time - period * std::floor(time / period)};
  state.displacement = {stop.position};
  state.velocity = {-law_of(scene, stop).restitution * sign(stop.side) * speed};
  return state;
}

// The orbit with this impact speed, from a guess of the parameter (that of the family's scene) and
// of the time of the impact. Throws std::runtime_error where there is none, another impact in
// between included.
inline ImpactOrbit one_impact_orbit(const ImpactFamily &family, double speed, double time) {
  ImpactOrbit guess;
  guess.speed = speed;
  guess.parameter = get(family.scene, family.parameter);
  guess.state = after_impact(family.scene, time, speed);
  const std::optional<ImpactOrbit> orbit = impact_orbit(family, guess, speed);
  if (!orbit || !orbit->real) throw std::runtime_error("no orbit of one impact with this speed");
  return *orbit;
}

// The multiplier next to `target`, +1 or -1.
inline double multiplier_near(const ImpactOrbit &orbit, double target) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const auto &multiplier : orbit.multipliers)
    if (std::abs(multiplier - target) < std::abs(nearest - target)) nearest = multiplier.real();
  return nearest;
}

// The fold (target 1) or the period doubling (-1) within a hundredth of the speed of `orbit`.
// Throws std::runtime_error where there is none.
inline ImpactOrbit bifurcation(const ImpactFamily &family, const ImpactOrbit &orbit,
                               double target) {
  const auto slower = impact_orbit(family, orbit, 0.99 * orbit.speed);
  const auto faster = impact_orbit(family, orbit, 1.01 * orbit.speed);
  if (!slower || !faster) throw std::runtime_error("the family ends beside this orbit");
  const auto found = target > 0.0 ? fold_between(family, *slower, *faster)
                                  : doubling_between(family, *slower, *faster);
  if (!found) throw std::runtime_error("no bifurcation beside this orbit");
  return *found;
}

}  // namespace vibro_impact::figures
