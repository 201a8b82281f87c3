// Event-driven simulation with plain means: sample the closed form, bracket, bisect, and resolve
// every single impact.
//
// Nothing is shared with the library on purpose, neither code nor method. In particular a chatter
// sequence is not taken to its limit here: its impacts are computed one by one until the speed is
// below 1e-20. At such a speed v the flight is some v^2 = 1e-40 high, and the gap, a difference of
// numbers of order one known to 1e-50, still has ten digits (the cancellation would take over near
// sqrt(1e-50) = 1e-25). There, if the force presses the mass into its stop, it sticks. The chatter
// that is left out lasts some 1e-19; that is the error of the generator.
#pragma once

#include "closed_form.hpp"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace vibro_impact_reference {

/// The thresholds of the generator, sized for 50 digits.
struct Resolution {
  Real speed_floor = Real("1e-20");     // a chatter is followed down to this speed
  Real pressing_floor = Real("1e-30");  // a hold force below this counts as zero: no stick
  Real hopeless_speed =
      Real("1e-24");  // bounces this slow without a pressing force are below the noise
  Real root_width =
      Real("1e-36");  // bisection stops at this fraction of the time since the last event
  Real simultaneous = Real("1e-33");  // roots this close, relative to the same time, are one event
  int samples_per_cycle = 128;        // of the fastest mode or of the forcing
};

struct Event {
  enum class Kind { impact, stick, release };
  Real time;
  std::size_t mass;  // from 0
  Kind kind;
  Real velocity_before;
  Real velocity_after;
  std::vector<bool> stuck;  // per mass, after the event
};

/// Called once for every piece of smooth motion with its flow and its duration.
using FlowObserver = std::function<void(const Flow &, const Real &duration)>;

/// A quantity that is positive while nothing happens (the gap of a free mass, the hold force of a
/// stuck one), with its first two time derivatives.
struct Signal {
  Real value, rate, curvature;
};

/// Bisection: `before` holds at a and no longer at b; returns the right end of a bracket of the
/// wanted width.
template <class Predicate>
Real bisect(const Predicate &before, Real a, Real b, const Real &relative_width) {
  const Real width = relative_width * b;
  while (b - a > width) {
    const Real middle = (a + b) / 2;
    if (middle <= a || middle >= b) break;
    (before(middle) ? a : b) = middle;
  }
  return b;
}

/// First time in (a, b] at which the signal falls through zero, if there is one. The piece is cut
/// where the curvature changes sign, so that the rate is monotone on every part: then a part has at
/// most one extremum, and a dip below zero between two positive samples (grazing) is found at the
/// minimum, itself bisected for from the rate.
template <class SignalAt>
std::optional<Real> first_fall(const SignalAt &signal_at, const Real &a, const Signal &at_a,
                               const Real &b, const Signal &at_b, const Real &root_width) {
  const Real h = b - a;
  const Real reach =
      h * (abs(at_a.rate) + abs(at_b.rate) + 2 * h * (abs(at_a.curvature) + abs(at_b.curvature)));
  if (at_a.value > reach && at_b.value > reach)
    return std::nullopt;  // too far from zero to get there and back

  if ((at_a.curvature > 0 && at_b.curvature < 0) || (at_a.curvature < 0 && at_b.curvature > 0)) {
    const bool positive = at_a.curvature > 0;
    const Real m =
        bisect([&](const Real &tau) { return (signal_at(tau).curvature > 0) == positive; }, a, b,
               root_width);
    Signal at_m = signal_at(m);
    at_m.curvature = 0;  // so that neither part is cut again
    if (m < b) {
      if (auto root = first_fall(signal_at, a, at_a, m, at_m, root_width)) return root;
      return first_fall(signal_at, m, at_m, b, at_b, root_width);
    }
  }

  if (at_a.rate >= 0) {
    if (at_b.rate >= 0 || at_b.value > 0) return std::nullopt;
    // Up, over the only maximum, and down through zero.
    return bisect(
        [&](const Real &tau) {
          const Signal s = signal_at(tau);
          return s.rate > 0 || s.value > 0;
        },
        a, b, root_width);
  }
  Real low = b;
  if (at_b.rate > 0) {
    // A minimum lies between: look for it, and stop as soon as a point below zero is met on the
    // way.
    Real left = a;
    const Real width = root_width * b;
    Real value = at_b.value;
    while (low - left > width) {
      const Real middle = (left + low) / 2;
      if (middle <= left || middle >= low) break;
      const Signal s = signal_at(middle);
      if (s.rate >= 0 || s.value <= 0) {
        low = middle;
        value = s.value;
        if (s.value <= 0) break;
      } else {
        left = middle;
      }
    }
    if (value > 0) return std::nullopt;
  } else if (at_b.value > 0) {
    return std::nullopt;
  }
  return bisect([&](const Real &tau) { return signal_at(tau).value > 0; }, a, low, root_width);
}

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
  Real force = amplitude * motion.cosine - chain.stiffnesses[p] * stop.position;
  Real rate = -omega * amplitude * motion.sine;
  Real curvature = -omega * omega * amplitude * motion.cosine;
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
  pulled,    // it rests there and is pulled away, at the start or by a jump of the force: gap and
             // speed are zero
  let_go,  // the hold force has just fallen through zero: gap, speed and acceleration are zero, the
           // gap opens
};

/// The state between two pieces of motion.
struct State {
  Real time;
  Vector x, v;
  std::vector<std::optional<std::size_t>> stuck_on;  // per mass: the stop (index) it rests on
  std::vector<Start> stop_start;                     // per stop
};

inline std::vector<bool> stuck_masses(const State &state) {
  std::vector<bool> stuck;
  for (const auto &stop : state.stuck_on) stuck.push_back(stop.has_value());
  return stuck;
}

/// The positions and velocities of a state as a Motion, enough for the value of a hold force.
inline Motion frozen(const Chain &chain, const State &state) {
  const std::size_t n = state.x.size();
  const Real phase = chain.frequency * state.time;
  return {state.x, state.v, Vector(n), Vector(n), cos(phase), sin(phase)};
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

/// First sampling step: a quarter of the shortest flight about to end, as far as gap, speed and
/// acceleration tell. The step then doubles from sample to sample, so it soon outgrows a wrong
/// guess.
inline Real first_step(const Scene &scene, const State &state,
                       const std::vector<std::optional<Signal>> &signals, const Real &longest) {
  Real step = longest;
  for (std::size_t i = 0; i < signals.size(); ++i) {
    if (!signals[i] || state.stuck_on[scene.stops[i].mass]) continue;
    const Signal &gap = *signals[i];
    if (gap.curvature >= 0 || gap.value < 0) continue;
    const Real flight =
        (gap.rate + sqrt(gap.rate * gap.rate - 2 * gap.curvature * gap.value)) / -gap.curvature;
    if (flight > 0 && flight / 4 < step) step = flight / 4;
  }
  return step;
}

/// The next events along a flow: the time since its start and the stops concerned (several if at
/// the same instant).
struct NextEvents {
  Real duration;
  std::vector<std::size_t> stops;
};

/// Samples the flow until something happens or `horizon` is reached (then no stop is named).
inline NextEvents find_next(const Scene &scene, const State &state, const Flow &flow,
                            const Real &horizon, const Resolution &resolution) {
  const Real two_pi = 2 * acos(Real(-1));
  const auto longest_at = [&](const Real &tau) -> Real {
    return two_pi / fastest_rate_at(flow, tau) / resolution.samples_per_cycle;
  };
  auto signals = starting_signals(scene, state, motion_at(flow, Real(0)));
  Real step = first_step(scene, state, signals, longest_at(Real(0)));
  Real a = 0;
  while (a < horizon) {
    const Real b = std::min<Real>(a + step, horizon);
    const Motion motion = motion_at(flow, b);
    std::vector<std::pair<Real, std::size_t>> roots;
    for (std::size_t i = 0; i < signals.size(); ++i) {
      const auto at_b = stop_signal(scene, state, i, motion);
      if (!at_b) continue;
      const auto signal_at = [&](const Real &tau) {
        return *stop_signal(scene, state, i, motion_at(flow, tau));
      };
      if (const auto root =
              first_fall(signal_at, a, *signals[i], b, *at_b, resolution.root_width)) {
        roots.emplace_back(*root, i);
      }
      signals[i] = at_b;
    }
    if (!roots.empty()) {
      const Real first = std::min_element(roots.begin(), roots.end())->first;
      NextEvents next{first, {}};
      for (const auto &[time, stop] : roots) {
        if (time - first <= resolution.simultaneous * first) next.stops.push_back(stop);
      }
      return next;
    }
    a = b;
    step = std::min<Real>(2 * step, longest_at(a));
  }
  return {horizon, {}};
}

/// Applies what happens at the present instant at the given stops: impacts of free masses, releases
/// of stuck ones; then sticks the masses whose chatter has run out, and lets go the stuck masses
/// that a neighbour's impact pulls away.
inline void apply_events(const Scene &scene, State &state, const std::vector<std::size_t> &stops,
                         const Resolution &resolution, std::vector<Event> &events) {
  const auto record = [&](std::size_t mass, Event::Kind kind, const Real &before,
                          const Real &after) {
    events.push_back({state.time, mass, kind, before, after, stuck_masses(state)});
  };
  std::vector<std::size_t> hit;
  for (const std::size_t i : stops) {
    const Stop &stop = scene.stops[i];
    const std::size_t p = stop.mass;
    state.x[p] = stop.position;
    if (state.stuck_on[p]) {
      state.stuck_on[p].reset();
      state.stop_start[i] = Start::let_go;
      record(p, Event::Kind::release, Real(0), Real(0));
    } else {
      const Real before = state.v[p];
      state.v[p] = -scene.restitution * before;
      state.stop_start[i] = Start::touching;
      hit.push_back(i);
      record(p, Event::Kind::impact, before, state.v[p]);
    }
  }
  for (const std::size_t i : hit) {
    const std::size_t p = scene.stops[i].mass;
    if (abs(state.v[p]) >= resolution.speed_floor) continue;
    const Real pressing =
        pressing_signal(scene.chain, scene.stops[i], frozen(scene.chain, state)).value;
    if (pressing > resolution.pressing_floor) {
      const Real before = state.v[p];
      state.v[p] = 0;
      state.stuck_on[p] = i;
      record(p, Event::Kind::stick, before, Real(0));
    } else if (pressing >= -resolution.pressing_floor &&
               abs(state.v[p]) < resolution.hopeless_speed) {
      // Bouncing about an equilibrium that lies on the stop: neither a stick nor a flight can be
      // told from rounding.
      throw std::runtime_error("mass " + std::to_string(p + 1) +
                               ": bounces under a vanishing hold force have become " +
                               "slower than the working precision resolves");
    }
  }
  for (std::size_t p = 0; p < state.x.size(); ++p) {
    if (!state.stuck_on[p]) continue;
    const std::size_t i = *state.stuck_on[p];
    // A force within rounding of zero decides nothing yet; its coming fall through zero is then
    // found along the flow.
    const Real pressing =
        pressing_signal(scene.chain, scene.stops[i], frozen(scene.chain, state)).value;
    if (pressing >= -resolution.pressing_floor) continue;
    state.stuck_on[p].reset();
    state.stop_start[i] = Start::pulled;
    record(p, Event::Kind::release, Real(0), Real(0));
  }
}

/// The state at t = 0; a mass that starts on a stop hits it, rests on it, or leaves it, as its
/// speed and the force say. Where the force is zero at t = 0 (all at rest, stop at zero), its
/// growth decides: it is looked up with the mass held.
inline State initial_state(const Scene &scene, const Resolution &resolution, Eigensystems &known,
                           std::vector<Event> &events) {
  const std::size_t n = scene.chain.masses.size();
  State state{Real(0), scene.initial_positions, scene.initial_velocities,
              std::vector<std::optional<std::size_t>>(n),
              std::vector<Start>(scene.stops.size(), Start::apart)};
  std::vector<std::size_t> hit, at_rest;
  std::vector<bool> held(n);
  for (std::size_t i = 0; i < scene.stops.size(); ++i) {
    const Stop &stop = scene.stops[i];
    if (state.x[stop.mass] != stop.position) continue;
    state.stop_start[i] = Start::touching;
    const Real closing = side_sign(stop) * state.v[stop.mass];
    if (closing > 0) hit.push_back(i);
    if (closing == 0) {
      at_rest.push_back(i);
      held[stop.mass] = true;
    }
  }
  const Motion motion =
      motion_at(flow_from(scene.chain, state.time, state.x, state.v, held, known), Real(0));
  for (const std::size_t i : at_rest) {
    const Signal pressing = pressing_signal(scene.chain, scene.stops[i], motion);
    bool sticks = true;
    for (const Real &order : {pressing.value, pressing.rate, pressing.curvature}) {
      if (abs(order) <= resolution.pressing_floor) continue;
      sticks = order > 0;
      break;
    }
    if (!sticks) {
      const bool zero = abs(pressing.value) <= resolution.pressing_floor;
      state.stop_start[i] = zero ? Start::let_go : Start::pulled;
      continue;
    }
    const std::size_t p = scene.stops[i].mass;
    state.stuck_on[p] = i;
    events.push_back({state.time, p, Event::Kind::stick, Real(0), Real(0), stuck_masses(state)});
  }
  apply_events(scene, state, hit, resolution, events);
  return state;
}

/// Carries a state on to the end time of the scene and appends every event in order. `known` are
/// the contact modes met so far.
inline void advance(const Scene &scene, State &state, Eigensystems &known,
                    std::vector<Event> &events, const FlowObserver &observe = {},
                    const Resolution &resolution = {}) {
  while (state.time < scene.end_time) {
    const std::vector<bool> stuck = stuck_masses(state);
    const Flow flow = flow_from(scene.chain, state.time, state.x, state.v, stuck, known);
    const NextEvents next = find_next(scene, state, flow, scene.end_time - state.time, resolution);
    if (observe) observe(flow, next.duration);
    const Motion motion = motion_at(flow, next.duration);
    state.time += next.duration;
    state.x = motion.x;  // resting masses keep their stop's position and zero speed exactly
    state.v = motion.v;
    std::fill(state.stop_start.begin(), state.stop_start.end(), Start::apart);
    if (next.stops.empty()) break;
    apply_events(scene, state, next.stops, resolution, events);
  }
}

/// Simulates a scene from t = 0 to its end time and returns every event in order. Events of several
/// masses at one instant carry the same time. Throws std::invalid_argument for a scene that breaks
/// a rule of require_valid, and std::runtime_error if a bounce under a vanishing hold force becomes
/// too slow for the working precision.
inline std::vector<Event> simulate(const Scene &scene, const FlowObserver &observe = {},
                                   const Resolution &resolution = {}) {
  require_valid(scene);
  std::vector<Event> events;
  Eigensystems known;
  State state = initial_state(scene, resolution, known, events);
  advance(scene, state, known, events, observe, resolution);
  return events;
}

}  // namespace vibro_impact_reference
