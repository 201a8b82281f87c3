// The impacts of one event: the impact law, the guard against endless work, and what follows from
// them (sticking, a neighbour's release, chatter).
#pragma once

#include <fmt/format.h>

#include <iterator>
#include <stdexcept>
#include <string>

#include "complete_chatter.hpp"

namespace vibro_impact::detail {

template <int D>
void count_impact(Run<D> &run, std::size_t stop, double speed) {
  ++run.counters.impacts;
  ++run.impacts_this_period;
  if (speed < run.last_speed[stop]) {
    ++run.falling[stop];
  } else {
    if (run.falling[stop] >= 5) ++run.counters.chatter_incomplete;
    run.falling[stop] = 0;
  }
  run.last_speed[stop] = speed;
  if (elapsed(run.period_start, run.state.now, run.clock) > run.guard_period) {
    run.period_start = run.state.now;
    run.impacts_this_period = 1;
  }
  if (run.impacts_this_period > run.options.max_impacts_per_period) {
    const MotionState motion = physical(run.state, run.scene);
    std::string text =
        fmt::format("more than {} impacts in one period, given up at t = {} with",
                    run.options.max_impacts_per_period, time_of(run.state.now, run.clock));
    for (Eigen::Index i = 0; i < motion.displacement.size(); ++i)
      fmt::format_to(std::back_inserter(text), " x{} = {}, x{}' = {}", i + 1,
                     motion.displacement(i), i + 1, motion.velocity(i));
    throw std::runtime_error(text);
  }
}

template <int D>
void handle_impact(Run<D> &run) {
  const std::vector<std::size_t> &stops = run.flight.event.stops;
  std::vector<double> &closing = run.closing;
  closing.clear();
  for (std::size_t stop : stops) {
    const double speed = std::min(0.0, run.state.stops[stop].speed);
    closing.push_back(speed);
    apply_impact(run.state, run.scene, open_stop(run.state, stop), speed);
    count_impact(run, stop, -speed);
  }
  const ContactMode<D> *before = run.state.mode;
  for (std::size_t k = 0; k < stops.size(); ++k) {
    const double velocity = -sign(run.scene.stops[stops[k]].side) * closing[k];
    emit(run, EventKind::impact, stops[k], velocity, -run.scene.restitution * velocity, false);
  }
  for (std::size_t stop : stops)
    if (run.state.stops[stop].speed == 0.0) settle(run, stop);
  if (run.scene.beta > 0.0) {
    for (std::size_t stop : stops)
      settle_beside(run, static_cast<std::size_t>(run.scene.stops[stop].mass - 1));
    for (std::size_t stop : stops)
      release_by_jump(run, static_cast<std::size_t>(run.scene.stops[stop].mass - 1));
  }

  // Chatter: not where r = 0 (one impact stops the mass) and not where r = 1 (it never ends).
  const double since_last = run.since_impact;
  run.since_impact = 0.0;
  run.flight_guess = std::numeric_limits<double>::infinity();
  if (run.state.mode != before || run.scene.restitution == 0.0 || run.scene.restitution == 1.0) {
    forget(run.chatter);
    return;
  }
  const double longest = longest_flight(run, stops);
  run.flight_guess = 1.1 * longest;
  if (!(longest * run.state.mode->fastest < 1.0)) {
    forget(run.chatter);
    return;
  }
  if (!gather(run.chatter, run.state, stops, since_last)) return;
  const bool new_node = extend(run.chatter, run.state, run.scene, run.stride);
  if (new_node) ++run.counters.chatter_nodes;
  const double now = time_of(run.state.now, run.clock);
  const double room =
      std::min(elapsed(run.state.now, run.end, run.clock), next_sample(run.recorders) - now);
  take_chatter_limit(run, stops, longest, new_node, room);
}

}  // namespace vibro_impact::detail
