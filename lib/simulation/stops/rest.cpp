#include "rest.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "simulation/chain/forces.hpp"
#include "simulation/chain/tolerances.hpp"

namespace vibro_impact::detail {

namespace {

// The stiffness of spring `i`, a link or below the links a spring to the ground.
double stiffness_of(const Scene &scene, std::size_t spring) {
  const std::size_t n = scene.mass.size();
  return spring < n ? scene.stiffness[spring] : scene.ground[spring - n];
}

std::size_t index_of(const Stop &stop) {
  return static_cast<std::size_t>(stop.mass - 1);
}

}  // namespace

// The force of springs and dampers on a mass, in one order.
RestDecision::Bounded RestDecision::force_on(const Scene &scene, std::size_t mass,
                                             double rate) const {
  const std::size_t n = scene.mass.size();
  const Real damping = static_cast<Real>(scene.beta) * rate;
  Bounded sum;
  const auto add = [&](std::size_t spring, Real sign) {
    const Bounded &force = current_.force[spring], &slope = current_.rate[spring];
    sum.value += sign * (force.value + damping * slope.value);
    sum.error += force.error + damping * slope.error;
  };
  add(mass, -1.0);
  if (mass + 1 < n) add(mass + 1, 1.0);
  if (!scene.ground.empty()) add(n + mass, -1.0);
  return sum;
}

// Decides the masses still undecided, order by order; a force within its error bound counts as
// zero. Returns how many are left.
std::size_t RestDecision::decide_by_order(const Scene &scene, double phase, double rate) {
  const std::size_t n = scene.mass.size();
  const double angle = scene.omega * phase, c = std::cos(angle), s = std::sin(angle);
  const std::array<double, 5> cosine{c, -s, -c, s, c};  // and its derivatives
  Real power = 1.0;                                     // (Omega / rate)^order
  current_ = start_;
  std::size_t left = 0;
  for (const RestingMass &mass : masses) left += kind_[mass.mass] == Kind::undecided;
  for (int order = 0; left > 0 && order < 2 * static_cast<int>(n) + 4; ++order) {
    ++orders;
    // The sine is minus the derivative of the cosine.
    const auto phase_order = static_cast<std::size_t>(order % 4);
    const ForcingFactors forcing{cosine[phase_order], -cosine[phase_order + 1], 0.0};
    const auto total_force = [&](std::size_t i) {
      Bounded force = force_on(scene, i, rate);
      force.value += power * external_force(scene, i, forcing);
      if (order == 0) force.value += external_force_of(scene, i).constant;
      return force;
    };
    const auto acceleration = [&](std::size_t i, const Bounded &force) {
      const Real inertia = static_cast<Real>(scene.mass[i]) * rate * rate;
      return Bounded{force.value / inertia, force.error / inertia};
    };
    for (std::size_t i = 0; i < n; ++i)
      acceleration_[i] = kind_[i] == Kind::moving ? acceleration(i, total_force(i)) : Bounded{};
    for (RestingMass &mass : masses) {
      if (kind_[mass.mass] != Kind::undecided) continue;
      const Bounded force = total_force(mass.mass);
      // Beyond the range of the numbers nothing is decided, and every order takes 100 times longer.
      if (!std::isfinite(force.value) || !std::isfinite(force.error)) return left;
      if ((order == 0 && mass.force_is_zero) || std::abs(force.value) <= force.error) continue;
      mass.held = mass.sigma * force.value > 0.0;
      mass.force = {.zeros = order};
      kind_[mass.mass] = mass.held ? Kind::held : Kind::moving;
      if (!mass.held) acceleration_[mass.mass] = acceleration(mass.mass, force);
      --left;
    }
    // F and F' become F' and F''.
    std::swap(current_.force, current_.rate);
    const auto set_second = [&](std::size_t spring, const Bounded &after, const Bounded &before) {
      const Real stiffness = stiffness_of(scene, spring);
      current_.rate[spring] = {stiffness * (after.value - before.value),
                               stiffness * (after.error + before.error)};
    };
    for (std::size_t i = 0; i < n; ++i) {
      set_second(i, acceleration_[i], i > 0 ? acceleration_[i - 1] : Bounded{});
      if (!scene.ground.empty()) set_second(n + i, acceleration_[i], {});
    }
    power *= static_cast<Real>(scene.omega) / rate;
  }
  return left;
}

void RestDecision::set_kinds(const Scene &scene, const Held &held) {
  const std::size_t n = scene.mass.size(), springs = scene.ground.empty() ? n : 2 * n;
  orders = 0;
  kind_.resize(n);
  acceleration_.assign(n, {});
  for (std::size_t i = 0; i < n; ++i) kind_[i] = held[i] != 0 ? Kind::held : Kind::moving;
  for (RestingMass &mass : masses) {
    kind_[mass.mass] = Kind::undecided;
    mass.held = false;
    mass.force = {.none = true};
  }
  start_.force.resize(springs);
  start_.rate.resize(springs);
}

// Sets the forces of link i, and of the spring of mass i to the ground, from the positions and
// velocities of masses i - 1 and i.
void RestDecision::set_exact_link(const Scene &scene, std::size_t i, double rate, double x_before,
                                  double v_before, double x, double v) {
  const auto set = [&](std::size_t spring, double stretch, double speed) {
    const Real stiffness = stiffness_of(scene, spring);
    start_.force[spring] = {stiffness * stretch, 0.0};
    start_.rate[spring] = {stiffness * speed / rate, 0.0};
  };
  // Differences first: a neighbour at the same position exerts no force at all.
  set(i, x - x_before, v - v_before);
  if (!scene.ground.empty()) set(scene.mass.size() + i, x, v);
}

void RestDecision::decide_from_start(const Scene &scene, double phase, double rate) {
  if (decide_by_order(scene, phase, rate) == 0) return;
  // Forces within their error bounds in all orders are decided by their rounded values.
  for (std::vector<Bounded> *numbers : {&start_.force, &start_.rate})
    for (Bounded &number : *numbers) number.error = 0.0;
  decide_by_order(scene, phase, rate);
}

void RestDecision::decide(const Scene &scene, const MotionState &exact, double rate) {
  set_kinds(scene, exact.held);
  for (std::size_t i = 0; i < scene.mass.size(); ++i) {
    set_exact_link(scene, i, rate, i > 0 ? exact.displacement[i - 1] : 0.0,
                   i > 0 ? exact.velocity[i - 1] : 0.0, exact.displacement[i], exact.velocity[i]);
  }
  decide_from_start(scene, exact.instant.phase, rate);
}

void RestDecision::decide(const Scene &scene, const Held &held, const ChainMotion &chain,
                          double phase, double rate) {
  set_kinds(scene, held);
  const Real error = row_rounding * chain.tension.stableNorm(),
             rate_error = row_rounding * chain.tension_rate.stableNorm() / rate;
  for (std::size_t i = 0; i < start_.force.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    const Real root = std::sqrt(stiffness_of(scene, i));
    start_.force[i] = {root * chain.tension(row), root * error};
    start_.rate[i] = {root * chain.tension_rate(row) / rate, root * rate_error};
  }
  // Links between masses at rest are exact.
  positions_.assign(held.size(), 0.0);
  for (const Stop &stop : scene.stops)
    if (held[index_of(stop)] == static_cast<signed char>(stop.side))
      positions_[index_of(stop)] = stop.position;
  for (const RestingMass &mass : masses) positions_[mass.mass] = scene.stops[mass.stop].position;
  for (std::size_t i = 0; i < held.size(); ++i)
    if (kind_[i] != Kind::moving && (i == 0 || kind_[i - 1] != Kind::moving))
      set_exact_link(scene, i, rate, i > 0 ? positions_[i - 1] : 0.0, 0.0, positions_[i], 0.0);
  decide_from_start(scene, phase, rate);
}

}  // namespace vibro_impact::detail
