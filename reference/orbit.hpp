// Orbits on which something is about to change, solved for as a whole: the state at a quiet phase
// of the forcing and the frequency together, so that the orbit closes and the condition holds.
#pragma once

#include "event_driven.hpp"
#include "solve.hpp"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <vector>

namespace vibro_impact_reference {

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

/// The motion from rest after `settling` orbits, as a start: its state in the middle of the longest
/// stretch without event in which no mass rests on a stop.
inline SoughtOrbit orbit_from_rest(Scene scene, int periods, int settling,
                                   const Resolution &resolution) {
  const Real period = period_at(scene.chain.frequency);
  Run run;
  State state = initial_state(scene, resolution, run);
  const Real settled = settling * periods * period;
  scene.end_time = settled;
  advance(scene, state, run, resolution);
  const State start = state;
  run.events.clear();
  scene.end_time = settled + periods * period;
  advance(scene, state, run, resolution);
  Real longest = 0, middle = 0;
  for (std::size_t i = 0; i + 1 < run.events.size(); ++i) {
    const std::vector<bool> &stuck = run.events[i].stuck;
    if (std::find(stuck.begin(), stuck.end(), true) != stuck.end()) continue;
    const Real gap = run.events[i + 1].time - run.events[i].time;
    if (gap <= longest) continue;
    longest = gap;
    middle = (run.events[i].time + run.events[i + 1].time) / 2;
  }
  state = start;
  scene.end_time = middle;
  advance(scene, state, run, resolution);
  SoughtOrbit orbit{scene, periods, (middle - settled) / period, state.x};
  orbit.unknowns.insert(orbit.unknowns.end(), state.v.begin(), state.v.end());
  orbit.unknowns.push_back(scene.chain.frequency);
  return orbit;
}

/// A frequency with an estimate of its error.
struct Located {
  Real value, error;
};

/// What a run over the periods of an orbit comes to.
using Condition = std::function<Real(const Scene &, const Run &)>;

/// Moves the unknowns of an orbit to where it closes and its condition has the value `target`;
/// returns the last step. `inverse` as in solve().
inline Real solve_orbit(SoughtOrbit &orbit, SquareMatrix &inverse, const Resolution &resolution,
                        const Condition &condition, const Real &target, const Real &tolerance) {
  const auto failure = [&](const Vector &unknowns) {
    Scene scene = orbit.scene;
    scene.chain.frequency = unknowns.back();
    const Real period = period_at(unknowns.back());
    scene.end_time = (orbit.phase + orbit.periods) * period;
    const auto middle = unknowns.begin() + static_cast<std::ptrdiff_t>(unknowns.size() / 2);
    State state = free_state(scene, orbit.phase * period, {unknowns.begin(), middle},
                             {middle, unknowns.end() - 1});
    Run run;
    advance(scene, state, run, resolution);
    Vector at_end = state.x;
    at_end.insert(at_end.end(), state.v.begin(), state.v.end());
    for (std::size_t i = 0; i < at_end.size(); ++i) at_end[i] -= unknowns[i];
    at_end.push_back(condition(scene, run) - target);
    return at_end;
  };
  return solve(failure, orbit.unknowns, inverse, tolerance);
}

}  // namespace vibro_impact_reference
