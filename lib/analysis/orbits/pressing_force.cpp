#include "vibro_impact/analysis/pressing_force.hpp"

#include <cmath>

#include "motion_state.hpp"

namespace vibro_impact {

namespace {

std::size_t index_of(const Stop &stop) {
  return static_cast<std::size_t>(stop.mass - 1);
}

// The coordinate j (from 0) that link_force asks for.
auto of(const std::vector<double> &values) {
  return [&values](std::size_t j) { return values[j]; };
}

// The state with the mass of this stop at rest there.
MotionState resting(const Scene &scene, const Stop &stop, MotionState state) {
  require_stop(scene, stop);
  require_fits(scene, state);
  state.displacement[index_of(stop)] = stop.position;
  state.velocity[index_of(stop)] = 0.0;
  return state;
}

}  // namespace

std::vector<double> acceleration(const Scene &scene, const MotionState &state) {
  check(scene);
  require_fits(scene, state);
  const double forcing = std::cos(scene.omega * state.instant.phase);
  std::vector<double> a(scene.mass.size(), 0.0);
  for (std::size_t i = 0; i < a.size(); ++i)
    if (state.held[i] == 0)
      a[i] =
          force_on(scene, i, of(state.displacement), of(state.velocity), forcing) / scene.mass[i];
  return a;
}

double pressing_force(const Scene &scene, const Stop &stop, const MotionState &state) {
  const MotionState rest = resting(scene, stop, state);
  return sign(stop.side) * force_on(scene, index_of(stop), of(rest.displacement), of(rest.velocity),
                                    std::cos(scene.omega * rest.instant.phase));
}

// The force depends linearly on the displacements and velocities of the neighbours: its derivative
// is the same function of their velocities and accelerations. The mass and its stop stand.
double pressing_force_rate(const Scene &scene, const Stop &stop, const MotionState &state) {
  const MotionState rest = resting(scene, stop, state);
  const std::size_t p = index_of(stop);
  const std::vector<double> a = acceleration(scene, rest);
  const double links = link_force(scene, p, 0.0, of(rest.velocity));
  const double dampers = scene.beta * link_force(scene, p, 0.0, of(a));
  const double forcing =
      -amplitude_on(scene, p) * scene.omega * std::sin(scene.omega * rest.instant.phase);
  return sign(stop.side) * (links + dampers + forcing);
}

}  // namespace vibro_impact
