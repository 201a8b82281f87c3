// The periodic orbits of one impact of one mass before one stop, from a guess in words of the
// impact: its time and its speed.
#pragma once

#include <cmath>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>

#include "vibro_impact/analysis/analysis.hpp"
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

struct OneImpactOrbit {
  PeriodicOrbit orbit;
  Event impact;

  double speed() const {
    return std::abs(impact.velocity_before);
  }
  // The multiplier next to -1: zero, with one added, at a period doubling.
  double doubling_multiplier() const {
    double nearest = orbit.multipliers.front().real();
    for (const auto &multiplier : orbit.multipliers)
      if (std::abs(multiplier + 1.0) < std::abs(nearest + 1.0)) nearest = multiplier.real();
    return nearest;
  }
};

// The orbit with one impact in `periods` periods near this guess. Throws std::runtime_error where
// there is none.
inline OneImpactOrbit one_impact_orbit(const Scene &scene, int periods, double time, double speed) {
  const MotionState guess = at_quiet_phase(scene, after_impact(scene, time, speed));
  const PeriodicOrbit orbit = find_periodic_orbit(scene, guess, periods);
  if (!orbit.converged) throw std::runtime_error("no orbit of one impact: " + orbit.why_not);
  EventRecorder told;
  stroboscopic_map(scene, orbit.state, periods, {}, told);
  if (told.events.size() != 1)
    throw std::runtime_error("the orbit has " + std::to_string(told.events.size()) +
                             " events, not one impact");
  return {orbit, told.events.front()};
}

// The zero of f near `x`, by secants from there and `step` away, to rounding.
inline double zero_near(const std::function<double(double)> &f, double x, double step) {
  double last = x, value = f(x);
  x += step;
  for (int iteration = 0; iteration < 20; ++iteration) {
    const double next_value = f(x), slope = (next_value - value) / (x - last);
    last = std::exchange(x, x - next_value / slope);
    value = next_value;
    if (!(std::abs(x - last) > 1e-14 * std::abs(x))) return x;
  }
  return x;
}

}  // namespace vibro_impact::figures
