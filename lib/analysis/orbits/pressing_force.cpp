#include "vibro_impact/analysis/pressing_force.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "motion.hpp"
#include "orbit_tolerances.hpp"
#include "vibro_impact/analysis/locate.hpp"
#include "vibro_impact/analysis/periodic_orbit.hpp"

namespace vibro_impact {

namespace {

// Puts the mass of this stop at rest on the stop.
void rest_on(const Stop &stop, MotionState &state) {
  state.displacement[index_of(stop.mass)] = stop.position;
  state.velocity[index_of(stop.mass)] = 0.0;
}

// The force on mass i (from 0) towards +x (Eq. 4). With the mass at rest at its stop it is the hold
// force (Eqs. 12-13). C = beta K.
double force_on(const Scene &scene, std::size_t i, const MotionState &state) {
  const double angle = scene.omega * state.instant.phase;
  return spring_force(scene, i, state.displacement) +
         scene.beta * spring_force(scene, i, state.velocity) +
         entry_of(scene.amplitude, i) * std::cos(angle) +
         entry_of(scene.sine, i) * std::sin(angle) + entry_of(scene.constant, i);
}

// The force depends linearly on the displacements and velocities of the neighbours: its derivative
// is the same function of their velocities and accelerations. The mass and its stop stand.
double pressing_force_rate(const Scene &scene, const Stop &stop, MotionState state) {
  rest_on(stop, state);
  const std::size_t p = index_of(stop.mass);
  std::vector<double> a = acceleration_of(scene, state);
  a[p] = 0.0;
  const double links = spring_force(scene, p, state.velocity);
  const double dampers = scene.beta * spring_force(scene, p, a);
  const double angle = scene.omega * state.instant.phase;
  const double forcing = scene.omega * (entry_of(scene.sine, p) * std::cos(angle) -
                                        entry_of(scene.amplitude, p) * std::sin(angle));
  return sign(stop.side) * (links + dampers + forcing);
}

// A function of the state where it is defined, and its time derivative.
struct Quantity {
  std::function<bool(const MotionState &)> defined;
  std::function<double(const MotionState &)> value, rate;
};

// Between neighbouring knots the motion has no event. A minimum lies where the quantity does not
// rise after the first knot, and rises before the second.
std::optional<LeastValue> least_minimum(const Scene &scene, const MotionState &start,
                                        const Quantity &quantity) {
  const Clock clock(scene.omega);
  const double every = std::min(clock.period / fewest_nodes, node_distance / rate_bound(scene));
  time_after(scene, start, 1);
  require(clock.period <= most_nodes * every, "rate = ", rate_bound(scene),
          ": too fast to look at a whole forcing period of ", clock.period);
  const Motion motion = motion_of(scene, start, 1, {}, {.every = every});
  std::optional<LeastValue> least;
  for (std::size_t k = 1; k < motion.knots.size(); ++k) {
    const MotionState &a = motion.knots[k - 1].state;
    MotionState b = motion.knots[k].state;
    b.held = a.held;
    if (motion.knots[k].event) undo_jump(*motion.knots[k].event, b.velocity);
    const double begin = time_of(a.instant, clock), length = elapsed(a.instant, b.instant, clock);
    if (!(length > 0.0) || !quantity.defined(a)) continue;
    if (quantity.rate(a) > 0.0 || !(quantity.rate(b) > 0.0)) continue;
    const auto state_after = [&](double time) {
      return require_complete(Simulation(scene, a).advance(begin + time)).state;
    };
    const auto rate = [&](double time) {
      if (time <= 0.0) return quantity.rate(a);
      return time >= length ? quantity.rate(b) : quantity.rate(state_after(time));
    };
    MotionState lowest = state_after(zero(rate, 0.0, length));
    const double value = quantity.value(lowest);
    if (!least || value < least->value) least = {value, std::move(lowest)};
  }
  return least;
}

}  // namespace

Eigen::VectorXd forces_without_dampers(const Scene &scene, const MotionState &state) {
  const double angle = scene.omega * state.instant.phase, cosine = std::cos(angle),
               sine = std::sin(angle);
  Eigen::VectorXd forces(static_cast<Eigen::Index>(scene.mass.size()));
  for (std::size_t i = 0; i < scene.mass.size(); ++i)
    forces(static_cast<Eigen::Index>(i)) =
        spring_force(scene, i, state.displacement) + entry_of(scene.amplitude, i) * cosine +
        entry_of(scene.sine, i) * sine + entry_of(scene.constant, i);
  return forces;
}

std::vector<double> acceleration_of(const Scene &scene, const MotionState &state) {
  std::vector<double> a(scene.mass.size(), 0.0);
  for (std::size_t i = 0; i < a.size(); ++i)
    if (state.held[i] == 0) a[i] = force_on(scene, i, state) / scene.mass[i];
  return a;
}

double pressing_force_of(const Scene &scene, const Stop &stop, MotionState state) {
  rest_on(stop, state);
  return sign(stop.side) * force_on(scene, index_of(stop.mass), state);
}

std::vector<double> acceleration(const Scene &scene, const MotionState &state) {
  check(scene);
  require_fits(scene, state);
  return acceleration_of(scene, state);
}

double pressing_force(const Scene &scene, const Stop &stop, const MotionState &state) {
  check(scene);
  require_stop(scene, stop);
  require_fits(scene, state);
  return pressing_force_of(scene, stop, state);
}

std::optional<LeastValue> least_pressing_force(const Scene &scene, const MotionState &start,
                                               const Stop &stop) {
  check(scene);
  require_stop(scene, stop);
  return least_minimum(
      scene, start,
      {[&](const MotionState &at) { return holds(stop, at.held); },
       [&](const MotionState &at) { return pressing_force_of(scene, stop, at); },
       [&](const MotionState &at) { return pressing_force_rate(scene, stop, at); }});
}

std::optional<LeastValue> least_gap(const Scene &scene, const MotionState &start,
                                    const Stop &stop) {
  check(scene);
  require_stop(scene, stop);
  const double sigma = sign(stop.side);
  const std::size_t p = index_of(stop.mass);
  return least_minimum(
      scene, start,
      {[p](const MotionState &at) { return at.held[p] == 0; },
       [&](const MotionState &at) { return sigma * (stop.position - at.displacement[p]); },
       [&](const MotionState &at) { return -sigma * at.velocity[p]; }});
}

}  // namespace vibro_impact
