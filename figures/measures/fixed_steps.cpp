#include "fixed_steps.hpp"

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace vibro_impact::figures {

namespace {

// x1, x2, x1', x2', cos(Omega t), sin(Omega t)
using State = Eigen::Vector<double, 6>;
using Matrix = Eigen::Matrix<double, 6, 6>;

// The matrix G of Eqs. 14-15, z' = G z, with both masses free.
Matrix generator_of(const Scene &scene) {
  const double k1 = scene.stiffness[0], k2 = scene.stiffness[1];
  Eigen::Matrix2d stiffness;
  stiffness << k1 + k2, -k2, -k2, k2;
  Matrix generator = Matrix::Zero();
  generator.block<2, 2>(0, 2).setIdentity();
  for (int i = 0; i < 2; ++i) {
    const auto mass = static_cast<std::size_t>(i);
    generator.block<1, 2>(2 + i, 0) = -stiffness.row(i) / scene.mass[mass];
    generator.block<1, 2>(2 + i, 2) = scene.beta * generator.block<1, 2>(2 + i, 0);
    generator(2 + i, 4) = scene.amplitude[mass] / scene.mass[mass];
  }
  generator(4, 5) = -scene.omega;
  generator(5, 4) = scene.omega;
  return generator;
}

// exp(G h) by thirty terms of its series, exact to rounding: for the largest step tried, 0.7, the
// norm of G h is below 2, and 2^31 / 31! is 3e-25.
Matrix exponential(const Matrix &exponent) {
  Matrix sum = Matrix::Identity(), term = sum;
  for (int n = 1; n <= 30; ++n) {
    term = term * exponent / n;
    sum += term;
  }
  return sum;
}

// The step of the masses that are free in a contact mode. The velocity of a held mass is zero and
// stays so.
Matrix step_of(Matrix generator, bool held1, bool held2, double step) {
  if (held1) generator.row(2).setZero();
  if (held2) generator.row(3).setZero();
  return exponential(generator * step);
}

}  // namespace

FollowedMotion follow_in_steps(const Scene &scene, MotionState state, double until,
                               const Procedure &procedure) {
  const double step = procedure.step;
  const Matrix generator = generator_of(scene);
  std::array<Matrix, 4> flows;  // by the held masses
  for (std::size_t mode = 0; mode < 4; ++mode)
    flows[mode] = step_of(generator, (mode & 1) != 0, (mode & 2) != 0, step);
  State motion{
      state.displacement[0], state.displacement[1], state.velocity[0], state.velocity[1], 1.0, 0.0};
  const long steps = std::lround(until / step);
  std::array<long, 2> last_impact = {-steps, -steps};  // of each mass, its step
  std::vector<Event> events;
  const auto add = [&](EventKind kind, int mass, double time, double before, double after) {
    events.push_back({.kind = kind,
                      .stop = mass,
                      .mass = mass,
                      .side = scene.stops[static_cast<std::size_t>(mass - 1)].side,
                      .time = time,
                      .velocity_before = before,
                      .velocity_after = after,
                      .held = state.held});
  };
  for (long n = 1; n <= steps; ++n) {
    const double time = static_cast<double>(n) * step;
    const std::size_t mode = (state.held[0] != 0 ? 1u : 0u) + (state.held[1] != 0 ? 2u : 0u);
    motion = flows[mode] * motion;
    for (int mass = 1; mass <= 2; ++mass) {
      const auto i = static_cast<std::size_t>(mass - 1);
      const Stop &stop = scene.stops[i];
      const double side = sign(stop.side);
      double &x = motion[mass - 1], &velocity = motion[mass + 1];
      const auto pressing = [&] {  // with the mass at rest at its stop
        return side * generator.row(mass + 1).dot(motion);
      };
      if (state.held[i] != 0) {
        if (pressing() > 0.0) continue;
        state.held[i] = 0;
        add(EventKind::release, mass, time, 0.0, 0.0);
      } else if (side * (x - stop.position) > 0.0) {
        const double before = std::exchange(velocity, 0.0), after = -scene.restitution * before;
        x = stop.position;
        add(EventKind::impact, mass, time, before, after);
        const auto flight = static_cast<double>(n - std::exchange(last_impact[i], n)) * step;
        if (flight < procedure.shortest_flight && pressing() > 0.0) {
          state.held[i] = static_cast<signed char>(stop.side);
          add(EventKind::stick, mass, time, 0.0, 0.0);
        } else {
          velocity = after;
        }
      }
    }
  }
  for (std::size_t i = 0; i < 2; ++i) {
    state.displacement[i] = motion[static_cast<Eigen::Index>(i)];
    state.velocity[i] = motion[static_cast<Eigen::Index>(i + 2)];
  }
  return {std::move(events), std::move(state)};
}

}  // namespace vibro_impact::figures
