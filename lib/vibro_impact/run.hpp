// What one run carries from event to event, and how it tells the recorders.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "chatter_tail.hpp"
#include "first_event.hpp"
#include "simulate.hpp"

namespace vibro_impact {

namespace detail {

// Everything one run carries from event to event.
template <int D>
struct Run {
  const Scene &scene;
  const RunOptions &options;
  std::span<const RecorderRef> recorders;
  Clock clock;
  Instant end;
  State<D> state;
  Modes<D> modes = {};
  Flight<D> flight = {};
  Chatter<D> chatter = {};
  Counters counters = {};
  std::optional<Remainder> remainder = {};  // of flights, where it is not below rounding
  long long stride = 1;
  double since_impact = 0.0;
  double flight_guess = std::numeric_limits<double>::infinity();
  long long impacts_this_period = 0;
  Instant period_start = {};
  std::vector<double> last_speed = {};  // per stop, of its last impact
  std::vector<int> falling = {};        // per stop, impacts in a row slower than the one before
  std::vector<double> closing = {};     // gap speeds before the impacts of one event
  bool takes_events = false;            // some recorder does
  bool takes_samples = false;
};

template <int D>
Moment moment_of(const State<D> &state, double time, const Scene &scene) {
  const auto of_mass = [&](double (*at)(const void *, const void *, int)) {
    return OfMass{&state, &scene, at};
  };
  return {state.now, time, of_mass([](const void *of, const void *, int mass) {
            const auto &[at, mode, value, slope, stops] = *static_cast<const State<D> *>(of);
            return mode->equilibrium(mass - 1) + mode->shape.row(mass - 1).dot(value.matrix());
          }),
          of_mass([](const void *of, const void *, int mass) {
            const auto &[at, mode, value, slope, stops] = *static_cast<const State<D> *>(of);
            return mode->shape.row(mass - 1).dot(slope.matrix());
          }),
          of_mass([](const void *of, const void *in, int mass) {
            const auto &[at, mode, value, slope, stops] = *static_cast<const State<D> *>(of);
            for (const auto &closed : mode->closed)
              if (closed.mass + 1 == static_cast<std::size_t>(mass))
                return sign(static_cast<const Scene *>(in)->stops[closed.stop].side) *
                       closed.press(value, slope);
            return std::numeric_limits<double>::quiet_NaN();
          })};
}

template <int D>
void emit(Run<D> &run, EventKind kind, std::size_t stop, double before, double after,
          bool by_a_jump) {
  if (!run.takes_events) return;
  const Stop &at = run.scene.stops[stop];
  const double time = time_of(run.state.now, run.clock);
  const Event event{
      kind, at.mass, at.side, run.state.now, time, before, after, run.state.mode->held, by_a_jump};
  const Moment moment = moment_of(run.state, time, run.scene);
  for (const RecorderRef &ref : run.recorders)
    if (ref.event != nullptr) ref.event(ref.recorder, event, moment);
}

inline double next_sample(std::span<const RecorderRef> recorders) {
  double next = std::numeric_limits<double>::infinity();
  for (const RecorderRef &ref : recorders)
    if (ref.sample != nullptr) next = std::min(next, ref.next_time(ref.recorder));
  return next;
}

// True when a recorder asks for a sample no later than `then`.
template <int D>
bool samples_by(const Run<D> &run, const Instant &then) {
  if (!run.takes_samples) return false;
  const double next = next_sample(run.recorders);
  return next < std::numeric_limits<double>::infinity() && next <= time_of(then, run.clock);
}

// Serves the sample times up to tau after the state, each by one closed-form modal evaluation.
template <int D>
void sample_flight(Run<D> &run, double tau) {
  if (!run.takes_samples) return;
  double next = next_sample(run.recorders);
  if (!(next < std::numeric_limits<double>::infinity())) return;
  State<D> between{run.state.now, run.state.mode, {}, {}, {}};
  while (next < std::numeric_limits<double>::infinity()) {
    const Instant instant = instant_at(next, run.clock);
    const double after = std::max(0.0, elapsed(run.state.now, instant, run.clock));
    if (after > tau) return;
    between.now = instant;
    flow(*run.state.mode, run.scene, run.state.value, run.state.slope, after, between.value,
         between.slope);
    ++run.counters.modal_evaluations;
    const Moment moment = moment_of(between, time_of(between.now, run.clock), run.scene);
    for (const RecorderRef &ref : run.recorders)
      if (ref.sample != nullptr && ref.next_time(ref.recorder) <= next)
        ref.sample(ref.recorder, moment);
    next = next_sample(run.recorders);
  }
}

template <int D>
const OpenStop<D> &open_stop(const State<D> &state, std::size_t stop) {
  return *std::find_if(state.mode->open.begin(), state.mode->open.end(),
                       [stop](const OpenStop<D> &open) { return open.stop == stop; });
}

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
  const Instant &from = run.period_start;
  if (Instant{from.cycle + 1, from.phase} < run.state.now) {
    run.period_start = run.state.now;
    run.impacts_this_period = 1;
  }
  if (run.impacts_this_period > run.options.max_impacts_per_period) {
    const auto &[now, mode, value, slope, stops] = run.state;
    const Eigen::VectorXd displacement = mode->equilibrium + mode->shape * value.matrix(),
                          velocity = mode->shape * slope.matrix();
    std::string text = fmt::format("more than {} impacts in one period, given up at t = {} with",
                                   run.options.max_impacts_per_period, time_of(now, run.clock));
    for (Eigen::Index i = 0; i < displacement.size(); ++i)
      fmt::format_to(std::back_inserter(text), " x{} = {}, x{}' = {}", i + 1, displacement(i),
                     i + 1, velocity(i));
    throw std::runtime_error(text);
  }
}

// Tells of the impacts at `stops`, of closing speeds `run.closing`.
template <int D>
void record_impacts(Run<D> &run, const std::vector<std::size_t> &stops) {
  for (std::size_t k = 0; k < stops.size(); ++k) count_impact(run, stops[k], -run.closing[k]);
  for (std::size_t k = 0; k < stops.size(); ++k) {
    const double velocity = -sign(run.scene.stops[stops[k]].side) * run.closing[k];
    emit(run, EventKind::impact, stops[k], velocity, -run.scene.restitution * velocity, false);
  }
}

}  // namespace detail

}  // namespace vibro_impact
