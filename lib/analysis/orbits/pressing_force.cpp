#include "vibro_impact/analysis/pressing_force.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "motion_state.hpp"
#include "orbit_tolerances.hpp"
#include "vibro_impact/analysis/locate.hpp"
#include "vibro_impact/analysis/periodic_orbit.hpp"

namespace vibro_impact {

namespace {

std::size_t index_of(const Stop &stop) {
  return static_cast<std::size_t>(stop.mass - 1);
}

// Puts the mass of this stop at rest on the stop.
void rest_on(const Stop &stop, MotionState &state) {
  state.displacement[index_of(stop)] = stop.position;
  state.velocity[index_of(stop)] = 0.0;
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
  const std::size_t p = index_of(stop);
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

// A time without events in which the quantity falls at first and rises at the end.
struct Bracket {
  MotionState start;
  double length, rate_at_end;
};

// Finds the brackets between neighbouring nodes: the events, with the motion before and after each,
// and uniform times that are close enough for the fastest mode.
struct BracketRecorder : Recorder {
  const Scene &scene;
  const Quantity &quantity;
  Held held;
  double from, to, every;
  std::size_t taken = 0;
  std::optional<MotionState> falling = {};
  std::vector<Bracket> brackets = {};

  BracketRecorder(const Scene &of, const Quantity &searched, const MotionState &start,
                  double distance)
      : scene(of),
        quantity(searched),
        held(start.held),
        from(start.instant.phase),
        to(from + Clock(of.omega).period),
        every(distance) {
  }
  double next_time() const override {
    return sample_time(from, to, every, taken);
  }
  void sample(const Moment &moment) override {
    ++taken;
    const MotionState state = state_at(moment, held);
    node(state, state);
  }
  void event(const Event &event, const Moment &moment) override {
    MotionState before = state_at(moment, held);
    undo_jump(event, before.velocity);
    held = event.held;
    node(before, state_at(moment, held));
  }
  void node(const MotionState &before, const MotionState &after) {
    if (falling && quantity.rate(before) > 0.0) {
      const double length = elapsed(falling->instant, before.instant, Clock(scene.omega));
      brackets.push_back({*falling, length, quantity.rate(before)});
    }
    falling.reset();
    if (quantity.defined(after) && quantity.rate(after) < 0.0) falling = after;
  }
};

std::optional<LeastValue> least_minimum(Simulation &simulation, MotionState start,
                                        const Quantity &quantity) {
  const Scene &scene = simulation.scene();
  start.instant.cycle = 0;  // times are then exact phases; the motion is the same in all periods
  const double period = Clock(scene.omega).period;
  const double every = std::min(period / fewest_nodes, node_distance / rate_bound(scene));
  require(period <= most_nodes * every, "rate = ", rate_bound(scene),
          ": too fast to look at a whole forcing period of ", period);
  BracketRecorder nodes(scene, quantity, start, every);
  stroboscopic_map(simulation, start, 1, nodes);
  std::optional<LeastValue> least;
  for (const Bracket &bracket : nodes.brackets) {
    const double begin = time_of(bracket.start.instant, Clock(scene.omega));
    const auto state_after = [&](double time) {
      simulation.start_from(bracket.start);
      return require_complete(simulation.advance(begin + time)).state;
    };
    const auto rate = [&](double time) {
      if (time <= 0.0) return quantity.rate(bracket.start);
      if (time >= bracket.length) return bracket.rate_at_end;
      return quantity.rate(state_after(time));
    };
    MotionState lowest = state_after(zero(rate, 0.0, bracket.length));
    const double value = quantity.value(lowest);
    if (!least || value < least->value) least = {value, std::move(lowest)};
  }
  return least;
}

}  // namespace

std::vector<double> acceleration_of(const Scene &scene, const MotionState &state) {
  std::vector<double> a(scene.mass.size(), 0.0);
  for (std::size_t i = 0; i < a.size(); ++i)
    if (state.held[i] == 0) a[i] = force_on(scene, i, state) / scene.mass[i];
  return a;
}

double pressing_force_of(const Scene &scene, const Stop &stop, MotionState state) {
  rest_on(stop, state);
  return sign(stop.side) * force_on(scene, index_of(stop), state);
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
  Simulation simulation(scene);
  require_stop(scene, stop);
  return least_minimum(
      simulation, start,
      {[&](const MotionState &at) { return holds(stop, at.held); },
       [&](const MotionState &at) { return pressing_force_of(scene, stop, at); },
       [&](const MotionState &at) { return pressing_force_rate(scene, stop, at); }});
}

std::optional<LeastValue> least_gap(const Scene &scene, const MotionState &start,
                                    const Stop &stop) {
  Simulation simulation(scene);
  require_stop(scene, stop);
  const double sigma = sign(stop.side);
  const std::size_t p = index_of(stop);
  return least_minimum(
      simulation, start,
      {[p](const MotionState &at) { return at.held[p] == 0; },
       [&](const MotionState &at) { return sigma * (stop.position - at.displacement[p]); },
       [&](const MotionState &at) { return -sigma * at.velocity[p]; }});
}

}  // namespace vibro_impact
