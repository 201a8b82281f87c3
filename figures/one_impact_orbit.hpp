// The periodic orbits of one impact, of one mass before one stop, with the impact speed as what is
// given: the speed parametrises them through folds and down to grazing, where a parameter of the
// scene does not. Every number is that of a run: the next impact as it is reported, and the exact
// derivative of the stroboscopic map.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <functional>
#include <stdexcept>
#include <vector>

#include "vibro_impact/vibro_impact.hpp"

namespace vibro_impact::figures {

// A scene as a function of the parameter that is solved for.
using SceneAt = std::function<Scene(double parameter)>;

struct OneImpactOrbit {
  int periods = 1;         // of the forcing, from impact to impact
  double speed = 0.0;      // of the impact, before it
  double parameter = 0.0;  // of the scene
  double time = 0.0;       // of the impact, in the first forcing period
  std::vector<std::complex<double>> multipliers = {};
};

// The state right after an impact of the one mass at `time`, with `speed` before it.
inline MotionState after_impact(const Scene &scene, double time, double speed) {
  const Stop &stop = scene.stops.front();
  const double outward = sign(stop.side) * speed;
  const Clock clock(scene.omega);
  MotionState state = start_of(scene);
  state.instant = instant_at(time - clock.period * std::floor(time / clock.period), clock);
  state.instant.cycle = 0;
  state.displacement = {stop.position};
  state.velocity = {-law_of(scene, stop).restitution * outward};
  return state;
}

// Ends a run at its first impact.
struct FirstImpact {
  bool met = false;
  Instant instant = {};
  double speed = 0.0;

  void event(const Event &event, const Moment &) {
    if (event.kind != EventKind::impact || met) return;
    met = true;
    instant = event.instant;
    speed = std::abs(event.velocity_before);
  }
  bool done() const {
    return met;
  }
};

// How far the next impact misses: its time from `periods` forcing periods later, its speed from
// `speed`. Throws std::runtime_error when none comes in twice that time.
inline std::array<double, 2> miss(const Scene &scene, double time, double speed, int periods) {
  const Clock clock(scene.omega);
  const MotionState start = after_impact(scene, time, speed);
  FirstImpact next;
  require_complete(simulate_from(scene, start, time_after(scene, start, 2 * periods), {}, next));
  if (!next.met) throw std::runtime_error("no impact follows");
  Instant due = start.instant;
  due.cycle += periods;
  return {elapsed(due, next.instant, clock), next.speed - speed};
}

// The orbit with this impact speed, by Newton's method in the parameter and the time of the impact
// from a guess of both. Throws std::runtime_error where there is none, another impact comes in
// between included.
inline OneImpactOrbit one_impact_orbit(const SceneAt &scene_at, double speed, int periods,
                                       double parameter, double time) {
  const auto residual = [&](double p, double t) { return miss(scene_at(p), t, speed, periods); };
  // The cube root of rounding, less near grazing: central differences good to its square.
  const double step = 0x1p-17 * std::min(1.0, speed);
  double least = std::numeric_limits<double>::infinity();
  OneImpactOrbit orbit{periods, speed, parameter, time};
  for (int iteration = 0; iteration < 12; ++iteration) {
    const auto at = residual(parameter, time);
    const double size = std::abs(at[0]) + std::abs(at[1]);
    if (!(size < least)) break;  // rounding has the last word
    least = size;
    orbit.parameter = parameter;
    orbit.time = time;
    const auto more_p = residual(parameter + step, time), less_p = residual(parameter - step, time);
    const auto more_t = residual(parameter, time + step), less_t = residual(parameter, time - step);
    const double pp = (more_p[0] - less_p[0]) / (2 * step),
                 pv = (more_p[1] - less_p[1]) / (2 * step),
                 tt = (more_t[0] - less_t[0]) / (2 * step),
                 tv = (more_t[1] - less_t[1]) / (2 * step);
    const double determinant = pp * tv - tt * pv;
    parameter -= (tv * at[0] - tt * at[1]) / determinant;
    time -= (pp * at[1] - pv * at[0]) / determinant;
  }
  if (!(least < 1e-11)) throw std::runtime_error("no orbit with this impact speed");
  const Scene scene = scene_at(orbit.parameter);
  const MotionState quiet = at_quiet_phase(scene, after_impact(scene, orbit.time, speed));
  orbit.multipliers = floquet_multipliers(
      stroboscopic_map_and_derivative(scene, quiet, periods).derivative, quiet.held);
  return orbit;
}

// The multiplier next to `target`, +1 or -1.
inline double multiplier_near(const OneImpactOrbit &orbit, double target) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const auto &multiplier : orbit.multipliers)
    if (std::abs(multiplier - target) < std::abs(nearest - target)) nearest = multiplier.real();
  return nearest;
}

// The bifurcation near `orbit` at which a multiplier passes through `target`: a fold for +1, a
// period doubling for -1. By secants over the impact speed.
inline OneImpactOrbit bifurcation(const SceneAt &scene_at, OneImpactOrbit orbit, double target) {
  const auto excess = [&](const OneImpactOrbit &at) {
    return multiplier_near(at, target) - target;
  };
  OneImpactOrbit before = one_impact_orbit(scene_at, orbit.speed * (1.0 + 1e-6), orbit.periods,
                                           orbit.parameter, orbit.time);
  for (int iteration = 0; iteration < 12 && std::abs(excess(orbit)) > 1e-12; ++iteration) {
    const double slope = (excess(orbit) - excess(before)) / (orbit.speed - before.speed);
    const double speed = orbit.speed - excess(orbit) / slope;
    before = orbit;
    orbit = one_impact_orbit(scene_at, speed, before.periods, before.parameter, before.time);
  }
  if (!(std::abs(excess(orbit)) < 1e-9)) throw std::runtime_error("no bifurcation found");
  return orbit;
}

}  // namespace vibro_impact::figures
