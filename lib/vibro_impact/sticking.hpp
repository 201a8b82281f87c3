// Sticking and release: changes of contact mode (Section 2.2 of the paper).
#pragma once

#include "counters.hpp"
#include "motion.hpp"

namespace vibro_impact {

// Enters the contact mode in which mass `mass` (from 0) is held as `how` says: +1, -1, or 0 (free).
// Positions and velocities are continuous; a held mass is at its stop and at rest exactly.
template <int D>
void change_mode(State<D> &state, const Scene &scene, Modes<D> &modes, std::size_t mass,
                 signed char how, Counters &counters) {
  Held held = state.mode->held;
  held[mass] = how;
  set_lanes(state, scene, modes.enter(scene, held, counters), masses_of(state, scene));
}

// The mass at stop `k` sticks: its gap and speed are zero.
template <int D>
void stick(State<D> &state, const Scene &scene, Modes<D> &modes, std::size_t k,
           Counters &counters) {
  const Stop &stop = scene.stops[k];
  const auto mass = static_cast<std::size_t>(stop.mass - 1);
  state.stops[k] = {};
  change_mode(state, scene, modes, mass, static_cast<signed char>(stop.side), counters);
  // An opposite stop of the same mass keeps the clearance as its gap until release.
  for (std::size_t other = 0; other < scene.stops.size(); ++other)
    if (other != k && scene.stops[other].mass == stop.mass)
      state.stops[other] = {std::abs(scene.stops[other].position - stop.position), 0.0, 0, 0.0};
  ++counters.sticks;
}

// Releases the mass held at stop `k`. `zeros` derivatives of its gap are zero by definition: 3 at a
// root of the hold force (gap, speed, acceleration), 2 when a neighbour's impact made the force
// jump. `leading` is the next derivative, > 0.
template <int D>
void release(State<D> &state, const Scene &scene, Modes<D> &modes, std::size_t k, int zeros,
             double leading, Counters &counters) {
  const auto mass = static_cast<std::size_t>(scene.stops[k].mass - 1);
  change_mode(state, scene, modes, mass, 0, counters);
  state.stops[k] = {0.0, 0.0, zeros, leading};
  ++counters.releases;
}

}  // namespace vibro_impact
