#include "rest.hpp"

#include <array>
#include <cmath>

#include "simulation/chain/forces.hpp"

namespace vibro_impact::detail {

// Decides the masses still undecided, order by order; a force within its error bound counts as
// zero. Returns how many are left.
std::size_t RestDecision::decide_by_order(const Scene &scene, double phase, double rate) {
  const std::size_t n = scene.mass.size();
  Derivatives &state = current_;
  const double angle = scene.omega * phase, c = std::cos(angle), s = std::sin(angle);
  const std::array<double, 5> cosine{c, -s, -c, s, c};  // and its derivatives
  double power = 1.0;                                   // (Omega / rate)^order
  std::size_t left = 0;
  for (const RestingMass &mass : masses) left += kind_[mass.mass] == Kind::undecided;
  for (int order = 0; left > 0 && order < 2 * static_cast<int>(n) + 4; ++order) {
    // The sine is minus the derivative of the cosine.
    const auto phase_order = static_cast<std::size_t>(order % 4);
    const ForcingFactors forcing{power * cosine[phase_order], -power * cosine[phase_order + 1],
                                 order == 0 ? 1.0 : 0.0};
    const auto force_of = [&](std::size_t i) {
      return force_on(
          scene, i, [&](std::size_t j) { return state.x[j]; },
          [&](std::size_t j) { return rate * state.v[j]; }, forcing);
    };
    // The error bound of the force: with -E_i in place of x_i all error bounds are added.
    const auto error_of = [&](std::size_t i) {
      return force_on(
          scene, i, [&](std::size_t j) { return j == i ? -state.x_error[j] : state.x_error[j]; },
          [&](std::size_t j) { return rate * (j == i ? -state.v_error[j] : state.v_error[j]); },
          {});
    };
    const auto set_acceleration = [&](std::size_t i, double force, double error) {
      state.a[i] = force / (scene.mass[i] * rate * rate);
      state.a_error[i] = error / (scene.mass[i] * rate * rate);
    };
    for (std::size_t i = 0; i < n; ++i) {
      const bool moves = kind_[i] == Kind::moving;
      set_acceleration(i, moves ? force_of(i) : 0.0, moves ? error_of(i) : 0.0);
    }
    for (RestingMass &mass : masses) {
      if (kind_[mass.mass] != Kind::undecided) continue;
      const double force = force_of(mass.mass), error = error_of(mass.mass);
      if ((order == 0 && mass.force_is_zero) || std::abs(force) <= error) continue;
      mass.held = mass.sigma * force > 0.0;
      kind_[mass.mass] = mass.held ? Kind::held : Kind::moving;
      if (!mass.held) set_acceleration(mass.mass, force, error);
      mass.leading = {order, mass.held ? mass.sigma * force : -mass.sigma * state.a[mass.mass]};
      --left;
    }
    // x, x', x'' become x', x'', and the oldest to be written over.
    state.x.swap(state.v);
    state.v.swap(state.a);
    state.x_error.swap(state.v_error);
    state.v_error.swap(state.a_error);
    power *= scene.omega / rate;
  }
  return left;
}

void RestDecision::decide(const Scene &scene, const MotionState &motion, double rate) {
  const std::size_t n = scene.mass.size();
  kind_.resize(n);
  start_.x = motion.displacement;
  start_.v = motion.velocity;
  start_.x_error = state_error;
  for (std::size_t i = 0; i < n; ++i) {
    start_.v[i] /= rate;
    kind_[i] = motion.held[i] != 0 ? Kind::held : Kind::moving;
  }
  for (const RestingMass &mass : masses) {
    kind_[mass.mass] = Kind::undecided;
    start_.x[mass.mass] = scene.stops[mass.stop].position;
  }
  for (std::size_t i = 0; i < n; ++i)  // a mass at rest is exactly at its stop
    if (kind_[i] != Kind::moving) start_.v[i] = start_.x_error[i] = 0.0;
  start_.a.assign(n, 0.0);
  start_.a_error.assign(n, 0.0);
  start_.v_error = start_.x_error;
  current_ = start_;
  if (decide_by_order(scene, motion.instant.phase, rate) == 0) return;
  // Forces within their error bounds in all orders are decided by their rounded values.
  start_.x_error.assign(n, 0.0);
  start_.v_error.assign(n, 0.0);
  current_ = start_;
  decide_by_order(scene, motion.instant.phase, rate);
}

}  // namespace vibro_impact::detail
