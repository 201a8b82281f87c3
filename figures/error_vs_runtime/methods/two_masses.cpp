#include "two_masses.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace vibro_impact::comparison {

TwoMasses two_masses(const Scene &scene) {
  const auto &stops = scene.stops;
  if (scene.masses() != 2 || stops.size() != 2 || stops[0].mass != 1 || stops[1].mass != 2)
    throw std::invalid_argument("the comparison takes two masses with one stop each");
  if (stops[0].restitution || stops[1].restitution)
    throw std::invalid_argument("the comparison takes no stop with a restitution of its own");
  for (const auto &[name, list] : {std::pair{"sine", &Scene::sine},
                                   {"constant", &Scene::constant},
                                   {"ground", &Scene::ground}})
    if (std::ranges::any_of(scene.*list, [](double force) { return force != 0.0; }))
      throw std::invalid_argument(
          fmt::format("the comparison takes no scene with forces '{}'", name));
  const double k1 = scene.stiffness[0], k2 = scene.stiffness[1];
  const double stiffness[2][2] = {{k1 + k2, -k2}, {-k2, k2}};
  TwoMasses chain{{}, {}, {}, scene.omega, scene.restitution};
  for (std::size_t i = 0; i < 2; ++i) {
    chain.side[i] = sign(scene.stops[i].side);
    chain.stop[i] = scene.stops[i].position;
  }
  // x_i = s_i - side_i g_i, so that u_i' = -side_i x_i''.
  for (std::size_t i = 0; i < 2; ++i) {
    GapEquation &e = chain.equation[i];
    const double per_mass = chain.side[i] / scene.mass[i];
    e.constant = 0.0;
    for (std::size_t j = 0; j < 2; ++j) {
      e.gap[j] = -per_mass * stiffness[i][j] * chain.side[j];
      e.speed[j] = scene.beta * e.gap[j];
      e.constant += per_mass * stiffness[i][j] * chain.stop[j];
    }
    e.drive = scene.amplitude.empty() ? 0.0 : -per_mass * scene.amplitude[i];
  }
  return chain;
}

GapState gap_state(const TwoMasses &chain, double time, const MotionState &state) {
  GapState gaps{.time = time};
  for (std::size_t i = 0; i < 2; ++i) {
    gaps.held[i] = state.held[i] != 0;
    if (gaps.held[i]) continue;
    gaps.y[2 * i] = chain.side[i] * (chain.stop[i] - state.displacement[i]);
    gaps.y[2 * i + 1] = -chain.side[i] * state.velocity[i];
  }
  return gaps;
}

void apply_event(const TwoMasses &chain, GapState &state, std::size_t i, double slowest,
                 Result &result) {
  const double cosine = std::cos(chain.omega * state.time);
  double &gap = state.y[2 * i], &speed = state.y[2 * i + 1];
  gap = 0.0;
  if (state.held[i]) {
    state.held[i] = false;
    speed = 0.0;
    return result.record(state.time, i, EventKind::release);
  }
  result.record(state.time, i, EventKind::impact, -chain.side[i] * speed);
  result.count_impact(state.time, i, speed);
  speed = std::abs(chain.restitution * speed);
  const double pressing = -chain.acceleration(i, state.y, cosine);
  if (speed < slowest && pressing > 0.0) {
    const double time_left = 2.0 * speed / (pressing * (1.0 - chain.restitution));
    speed = 0.0;
    state.held[i] = true;
    result.record(state.time + time_left, i, EventKind::stick);
  }
  const std::size_t j = 1 - i;
  if (state.held[j] && chain.acceleration(j, state.y, cosine) > 0.0) {
    state.held[j] = false;
    result.record(state.time, j, EventKind::release);
  }
}

double flight_ahead(const TwoMasses &chain, const GapState &state) {
  double flight = infinity;
  const double cosine = std::cos(chain.omega * state.time);
  for (std::size_t i = 0; i < 2; ++i) {
    if (state.held[i] || state.y[2 * i] != 0.0 || !(state.y[2 * i + 1] > 0.0)) continue;
    const double falling = -chain.acceleration(i, state.y, cosine);
    if (falling > 0.0) flight = std::min(flight, 2.0 * state.y[2 * i + 1] / falling);
  }
  return flight;
}

}  // namespace vibro_impact::comparison
