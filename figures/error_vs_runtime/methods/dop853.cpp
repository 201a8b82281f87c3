// DOP853 with its dense output in the common event loop: of two masses, and of chains of many equal
// masses with two stops on each, which never stick. The true events of a chain are its own, in
// `long double`.
#include "dop853.hpp"

#include <fmt/format.h>

#include <cmath>
#include <vector>

namespace vibro_impact::comparison {

namespace {

// The numbers of a motion: displacements, then velocities.
template <class Real>
struct ChainState {
  double time = 0.0;
  std::vector<Real> y = {};
};

template <class Real>
struct ChainSystem {
  const Scene &scene;
  const ChainState<Real> &now;

  // m_i x_i'' = A_i cos(Omega t) - T_i + T_(i+1), where T_i = k_i (z_i - z_(i-1)) is the force in a
  // spring and its damper, z = x + beta x'.
  void operator()(const std::vector<Real> &y, Real *dydt, double tau) const {
    const std::size_t masses = scene.mass.size();
    const double cosine = std::cos(scene.omega * (now.time + tau));
    Real last = 0;
    for (std::size_t i = 0; i < masses; ++i) {
      const Real z = y[i] + scene.beta * y[masses + i];
      const Real tension = scene.stiffness[i] * (z - last);
      if (i > 0) dydt[masses + i - 1] += tension / scene.mass[i - 1];
      dydt[i] = y[masses + i];
      dydt[masses + i] = (scene.amplitude[i] * cosine - tension) / scene.mass[i];
      last = z;
    }
  }
};

template <class Real>
Result run_chain(const Problem &problem, Real tolerance) {
  const Scene &scene = problem.scene;
  const std::size_t masses = scene.mass.size();
  ChainState<Real> now{problem.from, std::vector<Real>(2 * masses)};
  Result result;
  dop::Steps<std::vector<Real>, ChainSystem<Real>> steps{{scene, now}, tolerance, now.y};
  const auto guard = [&](std::size_t i, const auto &y, double) {
    const Stop &stop = scene.stops[i];
    return static_cast<double>(sign(stop.side) *
                               (stop.position - y[static_cast<std::size_t>(stop.mass - 1)]));
  };
  const auto event_of = [&](std::size_t i) {
    const Stop &stop = scene.stops[i];
    const auto mass = static_cast<std::size_t>(stop.mass - 1);
    Real &velocity = now.y[masses + mass];
    result.record(now.time, mass, EventKind::impact, static_cast<double>(velocity));
    now.y[mass] = stop.position;
    velocity *= -scene.restitution;
    result.count_impact(now.time, mass, static_cast<double>(velocity));
    return infinity;
  };
  advance(steps, now, problem.until, infinity, scene.stops.size(), guard, event_of, result.failure);
  return result;
}

Result run_dop853(const Problem &problem, double tolerance) {
  if (problem.scene.masses() != 2) return run_chain<double>(problem, tolerance);
  return with_events(problem, stick_below(tolerance), [&](const System &system) {
    return dop::Steps<Vec, System>{system, tolerance, system.now.y};
  });
}

}  // namespace

Problem chain_problem(std::size_t masses) {
  const std::vector<double> ones(masses, 1.0);
  Problem problem{.name = fmt::format("chain{}", masses),
                  .scene = {.mass = ones,
                            .stiffness = ones,
                            .beta = 0.1,
                            .amplitude = std::vector<double>(masses, 0.1),
                            .omega = 0.2,
                            .restitution = 0.7}};
  for (int mass = 1; mass <= static_cast<int>(masses); ++mass)
    for (const Side side : {Side::lower, Side::upper})
      problem.scene.stops.push_back({mass, side, sign(side) * 0.3});
  problem.start = start_of(problem.scene);
  problem.until = 2.0 * Clock(problem.scene.omega).period;
  problem.reference_events = run_chain<long double>(problem, 1e-16L).events;
  return problem;
}

std::vector<Method> dop853() {
  return {{"DOP853",
           {1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13, 1e-14},
           run_dop853,
           true}};
}

}  // namespace vibro_impact::comparison
