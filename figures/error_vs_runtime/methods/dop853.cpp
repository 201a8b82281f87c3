// DOP853 with its dense output in the common event loop: of two masses, and of chains of many equal
// masses with two stops on each, which never stick.
#include "dop853.hpp"

#include <cmath>
#include <vector>

namespace vibro_impact::comparison {

namespace {

// The numbers of a motion: displacements, then velocities.
struct ChainState {
  double time = 0.0;
  std::vector<double> y = {};
};

struct ChainSystem {
  const Scene &scene;
  const ChainState &now;

  // m_i x_i'' = A_i cos(Omega t) - T_i + T_(i+1), where T_i = k_i (z_i - z_(i-1)) is the force in a
  // spring and its damper, z = x + beta x'.
  void operator()(const std::vector<double> &y, double *dydt, double tau) const {
    const std::size_t masses = scene.mass.size();
    const double cosine = std::cos(scene.omega * (now.time + tau));
    double last = 0.0;
    for (std::size_t i = 0; i < masses; ++i) {
      const double z = y[i] + scene.beta * y[masses + i];
      const double tension = scene.stiffness[i] * (z - last);
      if (i > 0) dydt[masses + i - 1] += tension / scene.mass[i - 1];
      dydt[i] = y[masses + i];
      dydt[masses + i] = (scene.amplitude[i] * cosine - tension) / scene.mass[i];
      last = z;
    }
  }
};

Result run_chain(const Problem &problem, double tolerance) {
  const Scene &scene = problem.scene;
  const std::size_t masses = scene.mass.size();
  ChainState now{problem.from, std::vector<double>(2 * masses)};
  Result result;
  dop::Steps<std::vector<double>, ChainSystem> steps{{scene, now}, tolerance, now.y};
  const auto guard = [&](std::size_t i, const auto &y, double) {
    const Stop &stop = scene.stops[i];
    return sign(stop.side) * (stop.position - y[static_cast<std::size_t>(stop.mass - 1)]);
  };
  const auto event_of = [&](std::size_t i) {
    const Stop &stop = scene.stops[i];
    const auto mass = static_cast<std::size_t>(stop.mass - 1);
    double &velocity = now.y[masses + mass];
    result.record(now.time, mass, EventKind::impact, velocity);
    now.y[mass] = stop.position;
    velocity *= -scene.restitution;
    result.count_impact(now.time, mass, velocity);
    return infinity;
  };
  advance(steps, now, problem.until, infinity, scene.stops.size(), guard, event_of, result.failure);
  return result;
}

Result run_dop853(const Problem &problem, double tolerance) {
  if (problem.scene.masses() != 2) return run_chain(problem, tolerance);
  return with_events(problem, stick_below(tolerance), [&](const System &system) {
    return dop::Steps<Vec, System>{system, tolerance, system.now.y};
  });
}

}  // namespace

std::vector<Method> dop853() {
  return {{"DOP853",
           {1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13, 1e-14},
           run_dop853,
           true}};
}

}  // namespace vibro_impact::comparison
