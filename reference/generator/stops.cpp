#include "stops.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace vibro_impact_reference {

Signal pressing_signal(const Scene &scene, const Stop &stop, const Motion &motion) {
  const std::size_t p = stop.mass;
  const Vector &link = scene.stiffness;
  const Real &beta = scene.beta;
  const Real &omega = scene.omega;
  const Real &amplitude = scene.amplitude[p];
  const Real &sine = scene.sine[p];
  const Real turning = amplitude * motion.cosine + sine * motion.sine;
  Real force = turning + scene.constant[p] - (link[p] + scene.ground[p]) * stop.position;
  Real rate = omega * (sine * motion.cosine - amplitude * motion.sine);
  Real curvature = -omega * omega * turning;
  const auto add_neighbour = [&](std::size_t q, const Real &k) {
    force += k * (motion.x[q] + beta * motion.v[q]);
    rate += k * (motion.v[q] + beta * motion.a[q]);
    curvature += k * (motion.a[q] + beta * motion.jerk[q]);
  };
  if (p > 0) add_neighbour(p - 1, link[p]);
  if (p + 1 < scene.masses()) {
    force -= link[p + 1] * stop.position;
    add_neighbour(p + 1, link[p + 1]);
  }
  const double side = sign(stop.side);
  return {side * force, side * rate, side * curvature};
}

std::vector<bool> stuck_masses(const State &state) {
  std::vector<bool> stuck;
  for (const auto &stop : state.stuck_on) stuck.push_back(stop.has_value());
  return stuck;
}

std::optional<Signal> stop_signal(const Scene &scene, const State &state, std::size_t index,
                                  const Motion &motion) {
  const Stop &stop = scene.stops[index];
  const std::size_t p = stop.mass;
  if (state.stuck_on[p] == index) return pressing_signal(scene, stop, motion);
  if (state.stuck_on[p]) return std::nullopt;
  const double side = sign(stop.side);
  return Signal{side * (stop.position - motion.x[p]), -side * motion.v[p], -side * motion.a[p]};
}

Real pressing_now(const Scene &scene, const State &state, std::size_t stop) {
  const std::size_t n = state.x.size();
  const Real phase = scene.omega * state.time;
  const Motion now{state.x, state.v, Vector(n), Vector(n), cos(phase), sin(phase)};
  return pressing_signal(scene, scene.stops[stop], now).value;
}

std::vector<std::optional<Signal>> starting_signals(const Scene &scene, const State &state,
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

namespace {

/// True if the gaps of all free masses and the hold forces of all others stay positive along the
/// flow for `duration`: where the masses in question are concerned to within noise, and clear of it
/// at the end. Looked at eight times. `state` tells who is free.
bool stands(const Scene &scene, const State &state, const Flow &flow,
            const std::vector<std::size_t> &in_question, const Real &duration) {
  const Real noise = Real("1e-44");  // gaps and forces, of order one, are known to about this
  constexpr int samples = 8;
  for (int n = samples; n > 0; --n) {
    const Motion motion = motion_at(flow, duration * n / samples);
    for (std::size_t i = 0; i < scene.stops.size(); ++i) {
      const auto signal = stop_signal(scene, state, i, motion);
      if (!signal) continue;
      const bool asked = std::find(in_question.begin(), in_question.end(), i) != in_question.end();
      const Real least = !asked ? Real(0) : n == samples ? noise : Real(-noise);
      if (signal->value <= least) return false;
    }
  }
  return true;
}

}  // namespace

void decide_at_rest(const Scene &scene, State &state, const std::vector<std::size_t> &in_question,
                    Eigensystems &known) {
  if (in_question.size() > 12) throw std::runtime_error("more than 12 masses in question at once");
  const auto assigned = [&](unsigned held) {
    State result = state;
    for (std::size_t q = 0; q < in_question.size(); ++q) {
      const std::size_t i = in_question[q];
      auto &stuck_on = result.stuck_on[scene.stops[i].mass];
      if ((held >> q & 1u) != 0)
        stuck_on = i;
      else
        stuck_on.reset();
      result.stop_start[i] = Start::let_go;
    }
    result.decided = in_question;
    return result;
  };
  std::vector<Flow> flows;
  for (unsigned held = 0; held < 1u << in_question.size(); ++held)
    flows.push_back(
        flow_from(scene, state.time, state.x, state.v, stuck_masses(assigned(held)), known));
  // A quarter of a radian of the fastest mode or of the forcing, halved while none stands.
  Real duration = Real(0.25) / fastest_rate_at(flows.front(), Real(0));
  for (int halvings = 0; halvings <= 40; ++halvings, duration /= 2) {
    std::vector<State> standing;
    for (unsigned held = 0; held < flows.size(); ++held) {
      State trial_state = assigned(held);
      if (stands(scene, trial_state, flows[held], in_question, duration))
        standing.push_back(std::move(trial_state));
    }
    if (standing.empty()) continue;
    if (standing.size() > 1)
      throw std::runtime_error("time " + state.time.str(20) +
                               ": more than one way of holding the masses at rest stands");
    state = std::move(standing.front());
    state.decided_for = duration;
    return;
  }
  throw std::runtime_error("time " + state.time.str(20) +
                           ": no way of holding the masses at rest stands out from rounding");
}

}  // namespace vibro_impact_reference
