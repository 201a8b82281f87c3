// What one run carries from event to event, and how it tells the recorders.
#pragma once

#include <algorithm>
#include <limits>
#include <span>
#include <vector>

#include "chatter_limit.hpp"
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
  Flight flight = {};
  ChatterSequence<D> chatter = {};
  Counters counters = {};
  long long stride = 1;
  double since_impact = 0.0;
  double flight_guess = std::numeric_limits<double>::infinity();
  long long impacts_this_period = 0;
  Instant period_start = {};
  double guard_period = 0.0;
  std::vector<double> last_speed = {};  // per stop, of its last impact
  std::vector<int> falling = {};        // per stop, impacts in a row slower than the one before
  std::vector<double> closing = {};     // gap speeds before the impacts of one event
};

template <int D>
Moment moment_of(const State<D> &state, const Scene &scene, const Clock &clock) {
  const auto of_mass = [&](double (*at)(const void *, const void *, int)) {
    return OfMass{&state, &scene, at};
  };
  return {state.now, time_of(state.now, clock), of_mass([](const void *of, const void *, int mass) {
            const auto &[now, mode, value, slope, stops] = *static_cast<const State<D> *>(of);
            return mode->equilibrium(mass - 1) + mode->shape.row(mass - 1).dot(value.matrix());
          }),
          of_mass([](const void *of, const void *, int mass) {
            const auto &[now, mode, value, slope, stops] = *static_cast<const State<D> *>(of);
            return mode->shape.row(mass - 1).dot(slope.matrix());
          }),
          of_mass([](const void *of, const void *in, int mass) {
            const auto &[now, mode, value, slope, stops] = *static_cast<const State<D> *>(of);
            for (const ClosedStop<D> &closed : mode->closed)
              if (closed.mass + 1 == static_cast<std::size_t>(mass))
                return sign(static_cast<const Scene *>(in)->stops[closed.stop].side) *
                       closed.press(value, slope);
            return std::numeric_limits<double>::quiet_NaN();
          })};
}

template <int D>
void emit(const Run<D> &run, EventKind kind, std::size_t stop, double before, double after,
          bool by_a_jump) {
  const auto takes_events = [](const RecorderRef &ref) { return ref.event != nullptr; };
  if (std::none_of(run.recorders.begin(), run.recorders.end(), takes_events)) return;
  const Stop &at = run.scene.stops[stop];
  const Event event{kind,
                    at.mass,
                    at.side,
                    run.state.now,
                    time_of(run.state.now, run.clock),
                    before,
                    after,
                    run.state.mode->held,
                    by_a_jump};
  const Moment moment = moment_of(run.state, run.scene, run.clock);
  for (const RecorderRef &ref : run.recorders)
    if (ref.event != nullptr) ref.event(ref.recorder, event, moment);
}

inline double next_sample(std::span<const RecorderRef> recorders) {
  double next = std::numeric_limits<double>::infinity();
  for (const RecorderRef &ref : recorders)
    if (ref.sample != nullptr) next = std::min(next, ref.next_time(ref.recorder));
  return next;
}

// Serves the sample times up to tau after the state, each by one closed-form modal evaluation.
template <int D>
void sample_flight(Run<D> &run, double tau) {
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
    const Moment moment = moment_of(between, run.scene, run.clock);
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

}  // namespace detail

}  // namespace vibro_impact
