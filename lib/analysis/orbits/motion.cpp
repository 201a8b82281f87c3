#include "motion.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "vibro_impact/analysis/periodic_orbit.hpp"

namespace vibro_impact {

namespace {

struct MotionRecorder : Recorder {
  Motion &motion;
  Samples samples;
  Held held;
  double from, to;
  Clock clock;
  std::size_t taken = 0;

  MotionRecorder(Motion &of, const Samples &asked, double until)
      : motion(of),
        samples(asked),
        held(of.start().held),
        from(time_of(of.start().instant, Clock(of.scene.omega))),
        to(until),
        clock(of.scene.omega) {
  }
  // All impacts before the end are knots, also of a chatter whose limit lies behind the end.
  double slowest_impact(double, double limit) const override {
    return limit > to ? 0.0 : infinity;
  }
  double next_time() const override {
    if (samples.phase < 0.0)
      return samples.every < infinity ? sample_time(from, to, samples.every, taken) : infinity;
    if (taken == static_cast<std::size_t>(motion.periods)) return infinity;
    const Instant &first = motion.start().instant;
    const long long cycle = first.cycle + (samples.phase > first.phase ? 0 : 1);
    return std::min(time_of({cycle + static_cast<long long>(taken), samples.phase}, clock), to);
  }
  void sample(const Moment &moment) override {
    ++taken;
    motion.knots.push_back({state_at(moment, held)});
  }
  void event(const Event &event, const Moment &moment) override {
    held = event.held;
    motion.knots.push_back({state_at(moment, held), event});
  }
};

}  // namespace

Motion next_motion(Simulation &simulation, const MotionState &from, int periods,
                   const RunOptions &options, const Samples &samples) {
  Motion motion{simulation.scene(), options, periods, {{from}}};
  const double until = time_after(motion.scene, from, periods);
  MotionRecorder recorder(motion, samples, until);
  MotionState last = require_complete(simulation.advance(until, recorder)).state;
  motion.knots.push_back({std::move(last)});
  motion.knots.back().state.instant = {from.instant.cycle + periods, from.instant.phase};
  return motion;
}

Motion motion_of(const Scene &scene, MotionState start, int periods, const RunOptions &options,
                 const Samples &samples) {
  start.instant.cycle = 0;
  Simulation simulation(scene, start, options);
  return next_motion(simulation, start, periods, options, samples);
}

MotionState quiet_section(const Motion &motion) {
  const Clock clock(motion.scene.omega);
  double last = 0.0, widest = 0.0, middle = 0.0;
  int stop_of_impact = 0;
  const Knot *before = &motion.knots.front(), *begin = before;
  for (const Knot &knot : motion.knots) {
    const Event *event = knot.event ? &*knot.event : nullptr;
    if (!event && &knot != &motion.knots.back()) continue;
    const double time =
        std::min(elapsed(motion.start().instant, knot.state.instant, clock), clock.period);
    const bool in_chatter =
        event && event->kind == EventKind::stick && event->stop == stop_of_impact;
    if (time - last > widest && !in_chatter) {
      widest = time - last;
      middle = 0.5 * (last + time);
      begin = before;
    }
    last = time;
    before = &knot;
    stop_of_impact = event && event->kind == EventKind::impact ? event->stop : 0;
  }
  const double until = time_of(motion.start().instant, clock) + middle;
  MotionState state =
      require_complete(Simulation(motion.scene, begin->state, motion.options).advance(until)).state;
  state.instant.cycle = 0;
  return state;
}

std::vector<MotionState> samples_of(const Motion &motion) {
  std::vector<MotionState> states;
  for (std::size_t k = 1; k + 1 < motion.knots.size(); ++k)
    if (!motion.knots[k].event) states.push_back(motion.knots[k].state);
  return states;
}

std::vector<Event> events_of(const Motion &motion) {
  std::vector<Event> events;
  for (const Knot &knot : motion.knots)
    if (knot.event) events.push_back(*knot.event);
  return events;
}

double fastest_impact(const Motion &motion) {
  double fastest = 0.0;
  for (const Knot &knot : motion.knots)
    if (knot.event) fastest = std::max(fastest, std::abs(knot.event->velocity_before));
  return fastest;
}

double size_of(const Motion &motion) {
  const std::vector<double> frequencies = local_frequencies(motion.scene);
  double largest = 0.0;
  for (const Knot &knot : motion.knots) {
    double size = 0.0;
    for (std::size_t i = 0; i < frequencies.size(); ++i)
      size = std::hypot(size, knot.state.displacement[i], knot.state.velocity[i] / frequencies[i]);
    largest = std::max(largest, size);
  }
  return largest;
}

Eigen::VectorXd lengths(const std::vector<double> &frequencies, const MotionState &state) {
  const auto n = static_cast<Eigen::Index>(frequencies.size());
  Eigen::VectorXd z(2 * n);
  z << view(state.displacement), view(state.velocity).cwiseQuotient(view(frequencies));
  return z;
}

Eigen::VectorXd length_units(const Scene &scene) {
  const std::vector<double> frequencies = local_frequencies(scene);
  Eigen::VectorXd units = Eigen::VectorXd::Ones(2 * static_cast<Eigen::Index>(frequencies.size()));
  units.tail(units.size() / 2) = view(frequencies);
  return units;
}

Scene with_start_inside(Scene scene) {
  scene.displacement.resize(scene.mass.size(), 0.0);
  move_inside(scene, scene.displacement);
  return scene;
}

}  // namespace vibro_impact
