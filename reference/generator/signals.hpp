// The signals whose zeros are events: the gap of a free mass before each stop, and the hold force
// of a mass that rests on a stop.
#pragma once

#include "closed_form.hpp"
#include "roots.hpp"

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace vibro_impact_reference {

/// +1 for an upper stop, -1 for a lower one: the gap is side_sign (s - x), and a force pushes into
/// the stop if side_sign F > 0.
inline int side_sign(const Stop &stop) {
  return stop.side == Side::upper ? 1 : -1;
}

/// Gap of a free mass before a stop.
inline Signal gap_signal(const Stop &stop, const Motion &motion) {
  const int sign = side_sign(stop);
  const std::size_t p = stop.mass;
  return {sign * (stop.position - motion.x[p]), -sign * motion.v[p], -sign * motion.a[p]};
}

/// How hard the springs, dampers and the forcing push a mass that rests on its stop into it:
/// side_sign F_p of Eqs. 12 and 13, for a general chain, and its derivatives. The mass's own motion
/// does not enter.
inline Signal pressing_signal(const Chain &chain, const Stop &stop, const Motion &motion) {
  const std::size_t p = stop.mass;
  const Real &beta = chain.damping_ratio;
  const Real &omega = chain.frequency;
  const Real &amplitude = chain.amplitudes[p];
  const Real &sine = chain.sines[p];
  const Real turning = amplitude * motion.cosine + sine * motion.sine;
  Real force =
      turning + chain.constants[p] - (chain.stiffnesses[p] + chain.grounds[p]) * stop.position;
  Real rate = omega * (sine * motion.cosine - amplitude * motion.sine);
  Real curvature = -omega * omega * turning;
  const auto add_neighbour = [&](std::size_t q, const Real &k) {
    force += k * (motion.x[q] + beta * motion.v[q]);
    rate += k * (motion.v[q] + beta * motion.a[q]);
    curvature += k * (motion.a[q] + beta * motion.jerk[q]);
  };
  if (p > 0) add_neighbour(p - 1, chain.stiffnesses[p]);
  if (p + 1 < chain.masses.size()) {
    force -= chain.stiffnesses[p + 1] * stop.position;
    add_neighbour(p + 1, chain.stiffnesses[p + 1]);
  }
  const int sign = side_sign(stop);
  return {sign * force, sign * rate, sign * curvature};
}

/// What is known exactly at the start of a piece of motion, and would be noise if evaluated.
enum class Start {
  apart,     // the mass is away from its stop
  touching,  // it has just hit: the gap is zero
  pulled,    // it rests on the stop and is pulled away, at the start or by a jump of the force: gap
             // and speed are zero
  let_go,  // the hold force has just fallen through zero: gap, speed and acceleration are zero, the
           // gap opens
};

/// The state between two pieces of motion.
struct State {
  Real time;
  Vector x, v;
  std::vector<std::optional<std::size_t>> stuck_on;  // per mass: the stop (index) it rests on
  std::vector<Start> stop_start;                     // per stop
  // The masses that at_rest.hpp has decided, which keep this state for the time `decided_for`.
  std::vector<std::size_t> decided = {};  // stops
  Real decided_for = 0;
};

/// No mass rests on a stop or has just left one.
inline State free_state(const Scene &scene, const Real &time, const Vector &x, const Vector &v) {
  return {time, x, v, std::vector<std::optional<std::size_t>>(x.size()),
          std::vector<Start>(scene.stops.size(), Start::apart)};
}

inline std::vector<bool> stuck_masses(const State &state) {
  std::vector<bool> stuck;
  for (const auto &stop : state.stuck_on) stuck.push_back(stop.has_value());
  return stuck;
}

/// The signal of a stop: gap if its mass is free, hold force if it rests on this very stop, none
/// otherwise.
inline std::optional<Signal> stop_signal(const Scene &scene, const State &state, std::size_t index,
                                         const Motion &motion) {
  const Stop &stop = scene.stops[index];
  const auto &stuck_on = state.stuck_on[stop.mass];
  if (!stuck_on) return gap_signal(stop, motion);
  if (*stuck_on == index) return pressing_signal(scene.chain, stop, motion);
  return std::nullopt;
}

/// How hard a mass that rests on a stop is pressed into it at the present instant.
inline Real pressing_now(const Scene &scene, const State &state, std::size_t stop) {
  const std::size_t n = state.x.size();
  const Real phase = scene.chain.frequency * state.time;
  const Motion now{state.x, state.v, Vector(n), Vector(n), cos(phase), sin(phase)};
  return pressing_signal(scene.chain, scene.stops[stop], now).value;
}

/// Signals of all stops at the very start of a piece, with the exact zeros put in.
inline std::vector<std::optional<Signal>> starting_signals(const Scene &scene, const State &state,
                                                           const Motion &motion) {
  std::vector<std::optional<Signal>> signals;
  for (std::size_t i = 0; i < scene.stops.size(); ++i) {
    auto signal = stop_signal(scene, state, i, motion);
    if (signal && !state.stuck_on[scene.stops[i].mass] && state.stop_start[i] != Start::apart) {
      signal->value = 0;
      if (state.stop_start[i] == Start::pulled) signal->rate = 0;
      if (state.stop_start[i] == Start::let_go) {
        signal->rate = 0;
        signal->curvature = std::numeric_limits<Real>::min();  // 0, about to grow
      }
    }
    signals.push_back(signal);
  }
  return signals;
}

}  // namespace vibro_impact_reference
