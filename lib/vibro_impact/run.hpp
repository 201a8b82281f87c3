// What one run carries from event to event, and how it tells the recorders.
#pragma once

#include <algorithm>
#include <concepts>
#include <limits>
#include <type_traits>
#include <vector>

#include "chatter_limit.hpp"
#include "first_event.hpp"
#include "record.hpp"
#include "scene.hpp"

namespace vibro_impact {

struct RunOptions {
  // Chatter is carried to its limit only from impacts slower than this: every faster one is
  // resolved and recorded. 0 resolves chatter until what is left of it lies below rounding.
  double resolve_chatter = std::numeric_limits<double>::infinity();
  // Largest estimated relative error at which a chatter limit is accepted.
  double chatter_tolerance = 1e-13;
  // More impacts than this in one forcing period end the run with an error carrying the state.
  long long max_impacts_per_period = 1'000'000;
};

struct Outcome {
  MotionState state;  // at the end
  double time = 0.0;
  Counters counters;
};

// The initial state of a scene, at t = 0 with no mass held yet.
inline MotionState start_of(const Scene &scene) {
  const auto n = static_cast<Eigen::Index>(scene.mass.size());
  const auto vector = [n](const std::vector<double> &values) -> Eigen::VectorXd {
    if (values.empty()) return Eigen::VectorXd::Zero(n);
    return Eigen::Map<const Eigen::VectorXd>(values.data(), n);
  };
  return {Instant{}, vector(scene.displacement), vector(scene.velocity),
          Held(scene.mass.size(), 0)};
}

namespace detail {

// Everything one run carries from event to event.
template <int D>
struct Run {
  const Scene &scene;
  const RunOptions &options;
  Clock clock;
  Instant end;
  State<D> state;
  Modes<D> modes = {};
  Flight<D> flight = {};
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
};

template <class Recorder>
constexpr bool takes_events = requires(Recorder &r, const Event &e, const Moment &m) {
  r.event(e, m);
};
template <class Recorder>
constexpr bool takes_samples = requires(Recorder &r, const Moment &m) {
  r.sample(m);
  { r.next_time() } -> std::convertible_to<double>;
};

template <int D>
Moment moment_of(const State<D> &state, const Scene &scene, const Clock &clock) {
  return {state.now, time_of(state.now, clock),
          [&state](int mass) {
            return state.mode->equilibrium(mass - 1) +
                   state.mode->shape.row(mass - 1).dot(state.value.matrix());
          },
          [&state](int mass) { return state.mode->shape.row(mass - 1).dot(state.slope.matrix()); },
          [&state, &scene](int mass) {
            for (const ClosedStop<D> &closed : state.mode->closed)
              if (closed.mass + 1 == static_cast<std::size_t>(mass))
                return sign(scene.stops[closed.stop].side) * closed.press(state.value, state.slope);
            return std::numeric_limits<double>::quiet_NaN();
          }};
}

template <int D, class... Recorders>
void emit(const Run<D> &run, EventKind kind, std::size_t stop, double before, double after,
          bool by_a_jump, Recorders &...recorders) {
  if constexpr ((takes_events<Recorders> || ...)) {
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
    const auto tell = [&](auto &recorder) {
      if constexpr (takes_events<std::remove_reference_t<decltype(recorder)>>)
        recorder.event(event, moment);
    };
    (tell(recorders), ...);
  }
}

template <class... Recorders>
double next_sample(const Recorders &...recorders) {
  double next = std::numeric_limits<double>::infinity();
  [[maybe_unused]] const auto ask = [&next](const auto &recorder) {
    if constexpr (takes_samples<std::remove_cvref_t<decltype(recorder)>>)
      next = std::min(next, recorder.next_time());
  };
  (ask(recorders), ...);
  return next;
}

// Serves the sample times up to tau after `state`, each by one closed-form modal evaluation.
template <int D, class... Recorders>
void sample_flight(Run<D> &run, double tau, Recorders &...recorders) {
  if constexpr ((takes_samples<Recorders> || ...)) {
    double next = next_sample(recorders...);
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
      const auto tell = [&](auto &recorder) {
        if constexpr (takes_samples<std::remove_reference_t<decltype(recorder)>>)
          if (recorder.next_time() <= next) recorder.sample(moment);
      };
      (tell(recorders), ...);
      next = next_sample(recorders...);
    }
  }
}

template <int D>
const OpenStop<D> &open_stop(const State<D> &state, std::size_t stop) {
  return *std::find_if(state.mode->open.begin(), state.mode->open.end(),
                       [stop](const OpenStop<D> &open) { return open.stop == stop; });
}

}  // namespace detail

}  // namespace vibro_impact
