#include "signals.hpp"

#include <limits>

namespace vibro_impact_reference {

Signal pressing_signal(const Scene &scene, const Stop &stop, const Motion &motion) {
  const std::size_t p = stop.mass;
  const Vector &link = scene[&Field::stiffness];
  const Real &beta = scene[&Field::beta];
  const Real &omega = scene[&Field::omega];
  const Real &amplitude = scene[&Field::amplitude][p];
  const Real &sine = scene[&Field::sine][p];
  const Real turning = amplitude * motion.cosine + sine * motion.sine;
  Real force =
      turning + scene[&Field::constant][p] - (link[p] + scene[&Field::ground][p]) * stop.position;
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
  const Real phase = scene[&Field::omega] * state.time;
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

}  // namespace vibro_impact_reference
