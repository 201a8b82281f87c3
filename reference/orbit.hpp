// Orbits on which something is about to change, solved for as a whole: the state at a quiet phase
// of the forcing and the frequency together, so that the orbit closes and the condition holds.
#pragma once

#include "event_driven.hpp"
#include "solve.hpp"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace vibro_impact_reference {

/// What a run over the periods of an orbit shows, in the order of time.
using Observation =
    std::function<void(const Flow &, const Real &duration, const std::vector<Event> &events)>;

/// A periodic orbit of a scene that is looked for together with its frequency.
struct SoughtOrbit {
  Scene scene;      // its frequency is a start
  int periods;      // of the forcing
  Real phase;       // at which the state is taken, in periods of the forcing
  Vector unknowns;  // positions, velocities, frequency
};

inline Real period_at(const Real &frequency) {
  return 2 * acos(Real(-1)) / frequency;
}

/// By how much the orbit through these unknowns fails to close after its periods.
inline Vector failure_to_close(const SoughtOrbit &orbit, const Vector &unknowns,
                               const Resolution &resolution, const Observation &observe) {
  Scene scene = orbit.scene;
  const std::size_t n = scene.chain.masses.size();
  scene.chain.frequency = unknowns.back();
  const Real period = period_at(unknowns.back());
  scene.end_time = (orbit.phase + orbit.periods) * period;
  State state{orbit.phase * period,
              {unknowns.begin(), unknowns.begin() + static_cast<std::ptrdiff_t>(n)},
              {unknowns.begin() + static_cast<std::ptrdiff_t>(n), unknowns.end() - 1},
              std::vector<std::optional<std::size_t>>(n),
              std::vector<Start>(scene.stops.size(), Start::apart)};
  Eigensystems known;
  std::vector<Event> events;
  advance(
      scene, state, known, events,
      [&](const Flow &flow, const Real &duration) { observe(flow, duration, events); }, resolution);
  Vector failure;
  for (std::size_t i = 0; i < n; ++i) failure.push_back(state.x[i] - unknowns[i]);
  for (std::size_t i = 0; i < n; ++i) failure.push_back(state.v[i] - unknowns[n + i]);
  return failure;
}

/// The motion from rest after `settling` orbits, as a start: its state in the middle of the longest
/// stretch without event in which no mass rests on a stop.
inline SoughtOrbit orbit_from_rest(Scene scene, int periods, int settling,
                                   const Resolution &resolution) {
  const Real period = period_at(scene.chain.frequency);
  Eigensystems known;
  std::vector<Event> events;
  State state = initial_state(scene, resolution, known, events);
  const Real settled = settling * periods * period;
  scene.end_time = settled;
  advance(scene, state, known, events, {}, resolution);
  const State start = state;
  events.clear();
  scene.end_time = settled + periods * period;
  advance(scene, state, known, events, {}, resolution);
  Real longest = 0, middle = 0;
  for (std::size_t i = 0; i + 1 < events.size(); ++i) {
    const std::vector<bool> &stuck = events[i].stuck;
    if (std::find(stuck.begin(), stuck.end(), true) != stuck.end()) continue;
    const Real gap = events[i + 1].time - events[i].time;
    if (gap <= longest) continue;
    longest = gap;
    middle = (events[i].time + events[i + 1].time) / 2;
  }
  state = start;
  scene.end_time = middle;
  advance(scene, state, known, events, {}, resolution);
  SoughtOrbit orbit{scene, periods, (middle - settled) / period, state.x};
  orbit.unknowns.insert(orbit.unknowns.end(), state.v.begin(), state.v.end());
  orbit.unknowns.push_back(scene.chain.frequency);
  return orbit;
}

/// A frequency with an estimate of its error.
struct Located {
  Real value, error;
};

/// Moves the unknowns of an orbit to where it closes and its condition has the value `target`;
/// returns the last step. condition_of(scene) makes an observer of a run with observe(flow,
/// duration, events) and value(). `inverse` as in solve().
template <class ConditionOf>
Real solve_orbit(SoughtOrbit &orbit, Matrix &inverse, const Resolution &resolution,
                 const ConditionOf &condition_of, const Real &target, const Real &tolerance) {
  const auto failure = [&](const Vector &unknowns) {
    Scene at = orbit.scene;
    at.chain.frequency = unknowns.back();
    auto condition = condition_of(at);
    Vector failures = failure_to_close(
        orbit, unknowns, resolution,
        [&](const Flow &flow, const Real &duration, const std::vector<Event> &events) {
          condition.observe(flow, duration, events);
        });
    failures.push_back(condition.value() - target);
    return failures;
  };
  return solve(failure, orbit.unknowns, inverse, tolerance);
}

}  // namespace vibro_impact_reference
