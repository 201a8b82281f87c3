#include "event_driven.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace vibro_impact_reference {

Resolution resolution_down_to(const Real &floor) {
  return {floor, {std::min<Real>(Real("1e-36"), pow(floor, Real("1.6"))), true}};
}

std::string contact_mode(const std::vector<bool> &stuck) {
  std::vector<std::size_t> masses;
  for (std::size_t p = 0; p < stuck.size(); ++p)
    if (stuck[p]) masses.push_back(p + 1);
  return masses.empty() ? "-" : fmt::format("{}", fmt::join(masses, "+"));
}

namespace {

/// First sampling step: a quarter of the shortest flight about to end, as far as gap, speed and
/// acceleration tell. The step then doubles from sample to sample, so it soon outgrows a wrong
/// guess.
Real first_step(const Scene &scene, const State &state,
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

/// The signals of all stops.
std::vector<std::optional<Signal>> signals_of(const Scene &scene, const State &state,
                                              const Motion &motion) {
  std::vector<std::optional<Signal>> signals;
  for (std::size_t i = 0; i < scene.stops.size(); ++i)
    signals.push_back(stop_signal(scene, state, i, motion));
  return signals;
}

/// The next events along a flow: the time since its start and the stops concerned (several if at
/// the same instant).
struct NextEvents {
  Real duration;
  std::vector<std::size_t> stops;
};

/// Samples the flow until something happens or `horizon` is reached (then no stop is named). Zeros
/// a thousand widths apart are one event. In a long chain a hundred masses may hit within one
/// sampling step: the deepest one behind its stop is narrowed down first, and the others up to its
/// event alone.
NextEvents find_next(const Scene &scene, const State &state, const Flow &flow, const Real &horizon,
                     const Resolution &resolution) {
  const auto end_of_event = [&](const Real &zero) {
    return Real(zero + 1000 * resolution.roots.width_at(zero));
  };
  auto signals = starting_signals(scene, state, motion_at(flow, Real(0)));
  for (const std::size_t i : state.decided) signals[i].reset();
  Real step = first_step(scene, state, signals, sampling_step(flow, Real(0)));
  Real a = 0;
  while (a < horizon) {
    Real b = std::min<Real>(a + step, horizon);
    if (a < state.decided_for) b = std::min<Real>(b, state.decided_for);
    Real end = b;  // of the search for zeros
    Motion motion = motion_at(flow, end);
    auto at_b = signals_of(scene, state, motion);
    std::vector<std::size_t> searched;  // stops
    for (std::size_t i = 0; i < signals.size(); ++i)
      if (at_b[i] && signals[i]) searched.push_back(i);
    std::ranges::sort(searched, {}, [&](std::size_t i) { return at_b[i]->value; });
    std::vector<std::pair<Real, std::size_t>> roots;
    for (const std::size_t i : searched) {
      const auto signal_at = [&](const Real &tau) {
        return *stop_signal(scene, state, i, motion_at(flow, tau));
      };
      const auto root = first_fall(signal_at, a, *signals[i], end,
                                   *stop_signal(scene, state, i, motion), resolution.roots);
      if (!root) continue;
      roots.emplace_back(*root, i);
      if (end_of_event(*root) >= end) continue;
      end = end_of_event(*root);
      motion = motion_at(flow, end);
    }
    if (!roots.empty()) {
      const Real first = std::ranges::min_element(roots)->first;
      if (first < state.decided_for)
        throw std::runtime_error("an event comes before what has been decided stands");
      NextEvents next{first, {}};
      for (const auto &[time, stop] : roots) {
        if (time <= end_of_event(first)) next.stops.push_back(stop);
      }
      std::ranges::sort(next.stops);
      return next;
    }
    // Nothing happens at a stop without a signal before the time it is decided for.
    for (std::size_t i = 0; i < signals.size(); ++i)
      if (at_b[i] && (signals[i] || b >= state.decided_for)) signals[i] = at_b[i];
    a = b;
    step = std::min<Real>(2 * step, sampling_step(flow, a));
  }
  return {horizon, {}};
}

/// Decides who of the masses at rest at the stops `in_question` is held (stops.hpp), and records
/// the sticks and releases that follow.
void decide(const Scene &scene, State &state, const std::vector<std::size_t> &in_question,
            Run &run) {
  std::vector<bool> stuck = stuck_masses(state);
  decide_at_rest(scene, state, in_question, run.known);
  for (std::size_t p = 0; p < stuck.size(); ++p) {
    if (stuck[p] == state.stuck_on[p].has_value()) continue;
    stuck[p] = !stuck[p];
    run.events.push_back(
        {state.time, p, stuck[p] ? EventKind::stick : EventKind::release, Real(0), Real(0), stuck});
  }
}

/// Applies what happens at the present instant at the given stops: impacts of free masses, falls of
/// the hold force through zero of stuck ones. Then the masses whose chatter has run out stick,
/// those that a neighbour's impact pulls away are let go, and so is one whose hold force has
/// fallen; where several hold forces are zero at once, or one of a mass at rest after an impact
/// without rebound, it is decided by trial.
void apply_events(const Scene &scene, State &state, const std::vector<std::size_t> &stops,
                  const Resolution &resolution, Run &run) {
  const auto record = [&](std::size_t mass, EventKind kind, const Real &before, const Real &after,
                          const Real &left_out = Real(0)) {
    run.events.push_back({state.time, mass, kind, before, after, stuck_masses(state), left_out});
  };
  std::vector<std::size_t> hit, fallen, in_question;
  for (const std::size_t i : stops) {
    const std::size_t p = scene.stops[i].mass;
    state.x[p] = scene.stops[i].position;
    if (state.stuck_on[p]) {
      fallen.push_back(i);
      continue;
    }
    const Real before = state.v[p];
    state.v[p] = -scene.stops[i].restitution * before;
    state.stop_start[i] = Start::touching;
    hit.push_back(i);
    record(p, EventKind::impact, before, state.v[p]);
  }
  for (const std::size_t i : hit) {
    const std::size_t p = scene.stops[i].mass;
    if (abs(state.v[p]) >= resolution.speed_floor) continue;
    const Real pressing = pressing_now(scene, state, i);
    if (pressing > pressing_floor) {
      const Real before = state.v[p];
      state.v[p] = 0;
      state.stuck_on[p] = i;
      const Real acceleration = pressing / scene.mass[p];
      record(p, EventKind::stick, before, Real(0),
             before == 0
                 ? Real(0)
                 : Real(2 * abs(before) / (acceleration * (1 - scene.stops[i].restitution))));
    } else if (pressing < -pressing_floor) {
      if (state.v[p] == 0) state.stop_start[i] = Start::pulled;  // hit without rebound
    } else if (state.v[p] == 0) {
      in_question.push_back(i);
    } else if (abs(state.v[p]) < resolution.speed_floor / 10000) {
      // Bouncing about an equilibrium that lies on the stop: neither a stick nor a flight can be
      // distinguished from rounding.
      throw std::runtime_error("mass " + std::to_string(p + 1) +
                               ": bounces under a vanishing hold force have become " +
                               "slower than the working precision resolves");
    }
  }
  const auto let_go = [&](std::size_t i, Start start) {
    state.stuck_on[scene.stops[i].mass].reset();
    state.stop_start[i] = start;
    record(scene.stops[i].mass, EventKind::release, Real(0), Real(0));
  };
  const bool unsettled = !in_question.empty() || !fallen.empty();
  for (const auto &stuck_on : std::vector(state.stuck_on)) {
    if (!stuck_on) continue;
    const Real pressing = pressing_now(scene, state, *stuck_on);
    if (pressing < -pressing_floor)
      let_go(*stuck_on, Start::pulled);
    else if (unsettled && pressing <= pressing_floor)
      in_question.push_back(*stuck_on);
    // Otherwise a force within rounding of zero decides nothing yet; its coming fall through zero
    // is then found along the flow.
  }
  if (in_question.size() == 1 && in_question == fallen)
    let_go(fallen.front(), Start::let_go);
  else if (!in_question.empty())
    decide(scene, state, in_question, run);
}

}  // namespace

State initial_state(const Scene &scene, const Resolution &resolution, Run &run) {
  State state{.time = 0,
              .x = scene.displacement,
              .v = scene.velocity,
              .stuck_on = std::vector<std::optional<std::size_t>>(scene.masses()),
              .stop_start = std::vector<Start>(scene.stops.size(), Start::apart)};
  std::vector<std::size_t> hit, at_rest, in_question;
  for (std::size_t i = 0; i < scene.stops.size(); ++i) {
    const Stop &stop = scene.stops[i];
    if (state.x[stop.mass] != stop.position) continue;
    state.stop_start[i] = Start::touching;
    const Real closing = sign(stop.side) * state.v[stop.mass];
    if (closing > 0) hit.push_back(i);
    if (closing == 0) at_rest.push_back(i);
  }
  apply_events(scene, state, hit, resolution, run);
  for (const std::size_t i : at_rest) {
    const std::size_t p = scene.stops[i].mass;
    const Real pressing = pressing_now(scene, state, i);
    if (abs(pressing) <= pressing_floor) {
      in_question.push_back(i);
    } else if (pressing < 0) {
      state.stop_start[i] = Start::pulled;
    } else {
      state.stuck_on[p] = i;
      run.events.push_back(
          {state.time, p, EventKind::stick, Real(0), Real(0), stuck_masses(state)});
    }
  }
  if (!in_question.empty()) decide(scene, state, in_question, run);
  return state;
}

void advance(const Scene &scene, State &state, Run &run, const Resolution &resolution) {
  while (state.time < scene.end_time) {
    const std::vector<bool> stuck = stuck_masses(state);
    const Flow flow = flow_from(scene, state.time, state.x, state.v, stuck, run.known);
    const NextEvents next = find_next(scene, state, flow, scene.end_time - state.time, resolution);
    const Motion motion = motion_at(flow, next.duration);
    state.time += next.duration;
    state.x = motion.x;  // resting masses keep their stop's position and zero speed exactly
    state.v = motion.v;
    std::fill(state.stop_start.begin(), state.stop_start.end(), Start::apart);
    state.decided.clear();
    state.decided_for = 0;
    run.pieces.push_back({flow, next.duration});
    if (next.stops.empty()) break;
    apply_events(scene, state, next.stops, resolution, run);
  }
}

Run simulate(const Scene &scene, const Resolution &resolution) {
  Run run;
  State state = initial_state(scene, resolution, run);
  advance(scene, state, run, resolution);
  return run;
}

}  // namespace vibro_impact_reference
