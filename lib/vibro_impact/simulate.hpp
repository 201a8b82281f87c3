// The pipeline: chain -> contact mode -> flow -> first event -> impact / chatter limit / sticking
// -> record.
#pragma once

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "chatter_limit.hpp"
#include "first_event.hpp"
#include "impact.hpp"
#include "record.hpp"
#include "scene.hpp"
#include "sticking.hpp"

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

template <int D, class... Recorders>
void stick_at(Run<D> &run, std::size_t stop, Recorders &...recorders) {
  stick(run.state, run.scene, run.modes, stop, run.counters);
  run.falling[stop] = 0;
  run.chatter.size = 0;
  emit(run, EventKind::stick, stop, 0.0, 0.0, false, recorders...);
}

template <int D, class... Recorders>
void release_at(Run<D> &run, std::size_t stop, int zeros, double leading, Recorders &...recorders) {
  release(run.state, run.scene, run.modes, stop, zeros, leading, run.counters);
  run.chatter.size = 0;
  run.last_speed[stop] = 0.0;
  emit(run, EventKind::release, stop, 0.0, 0.0, zeros == 2, recorders...);
}

// A mass at rest at its stop: it sticks when pressed, else leaves with the acceleration it has.
template <int D, class... Recorders>
void settle(Run<D> &run, std::size_t stop, Recorders &...recorders) {
  const OpenStop<D> &open = open_stop(run.state, stop);
  const double press = open.press(run.state.value, run.state.slope);
  if (press > 0.0) {
    stick_at(run, stop, recorders...);
  } else {
    run.state.stops[stop] = {0.0, 0.0, 2, -press / run.scene.mass[open.mass]};
  }
}

// A neighbour's impact makes the hold force jump; where it changes sign the mass leaves at once.
template <int D, class... Recorders>
void release_by_jump(Run<D> &run, std::size_t mass, Recorders &...recorders) {
  for (std::size_t k = 0; k < run.state.mode->closed.size();) {
    const ClosedStop<D> &closed = run.state.mode->closed[k];
    const std::size_t distance = closed.mass > mass ? closed.mass - mass : mass - closed.mass;
    const double press = distance == 1 ? closed.press(run.state.value, run.state.slope) : 0.0;
    if (press < 0.0) {
      release_at(run, closed.stop, 2, -press / run.scene.mass[closed.mass], recorders...);
      k = 0;  // the contact mode has changed
    } else {
      ++k;
    }
  }
}

// True when nothing else can happen within tau: every other gap and hold force keeps clear of zero
// by more than the impacts left in the chatter (total impulse per mass `impulse`) can move it.
template <int D>
bool clear_until(Run<D> &run, double tau, double impulse) {
  const ContactMode<D> &mode = *run.state.mode;
  expand(mode, run.state.value, run.state.slope, tau, run.flight.expansion, run.counters);
  const double stiffest = mode.lambda.maxCoeff(), most_damped = mode.kappa.maxCoeff();
  const double gap_margin = tau * tau * (most_damped + stiffest * tau) * impulse;
  const double link = *std::max_element(run.scene.stiffness.begin(), run.scene.stiffness.end());
  const double force_margin = link * (run.scene.beta + tau) * impulse;
  const auto one = [](int) { return 1.0; };
  for (const OpenStop<D> &open : mode.open) {
    if (std::find(run.chatter.stops.begin(), run.chatter.stops.end(), open.stop) !=
        run.chatter.stops.end())
      continue;
    const StopState &stop = run.state.stops[open.stop];
    if (stop.zeros != 0 ||
        lower_bound(gap_polynomial(open, stop, run.flight.expansion), 0, one) <= gap_margin)
      return false;
  }
  for (const ClosedStop<D> &closed : mode.closed)
    if (lower_bound(polynomial_of(closed.press, run.flight.expansion, true), 0, one) <=
        force_margin)
      return false;
  return true;
}

// Carries a complete chatter to its limit when that is certain; true when it did.
template <int D, class... Recorders>
bool take_chatter_limit(Run<D> &run, bool new_node, double press, double tau_at_most,
                        Recorders &...recorders) {
  const std::size_t first = run.chatter.stops.front();
  const double r = run.scene.restitution, speed = run.state.stops[first].speed;
  const double mass = run.scene.mass[static_cast<std::size_t>(run.scene.stops[first].mass - 1)];
  const double tail = 2.0 * speed * mass / (press * (1.0 - r));  // to leading order in the speed
  if (tail > 2.0 * tau_at_most) return false;

  std::optional<ChatterLimit<D>> limit;
  if (tail * run.state.mode->fastest < 1e-9) {
    // What is left is below rounding: its leading order is its limit, with an error of order
    // tail^2.
    limit.emplace(ChatterLimit<D>{tail, run.state, 0.0});
    expand(*run.state.mode, run.state.value, run.state.slope, tail, run.flight.expansion,
           run.counters);
    read_gaps(run.state, run.flight);
    move_to(limit->state, run.flight, 1.0, run.scene, run.clock);
  } else if (new_node && speed < run.options.resolve_chatter) {
    limit = extrapolate(run.chatter, run.options.chatter_tolerance);
  }
  if (!limit || !(limit->tau < tau_at_most)) return false;
  if (!clear_until(run, limit->tau, (1.0 + r) / (1.0 - r) * speed)) return false;
  limit->state.now = later(run.state.now, limit->tau, run.clock);
  set_forcing(limit->state, run.scene);
  for (std::size_t stop : run.chatter.stops)
    if (!(open_stop(run.state, stop).press(limit->state.value, limit->state.slope) > 0.0))
      return false;  // a border orbit or beyond: the chatter is not complete

  sample_flight(run, 0.0, recorders...);
  run.state = std::move(limit->state);
  const std::vector<std::size_t> stops = run.chatter.stops;
  for (std::size_t stop : stops) run.state.stops[stop] = {};
  for (std::size_t stop : stops) stick_at(run, stop, recorders...);
  ++run.counters.chatter_limits;
  return true;
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

template <int D, class... Recorders>
void handle_impact(Run<D> &run, Recorders &...recorders) {
  const std::vector<std::size_t> &stops = run.flight.event.stops;
  std::vector<double> closing;
  for (std::size_t stop : stops) {
    const double speed = std::min(0.0, run.state.stops[stop].speed);
    closing.push_back(speed);
    apply_impact(run.state, run.scene, open_stop(run.state, stop), speed);
    count_impact(run, stop, -speed);
  }
  const ContactMode<D> *before = run.state.mode;
  for (std::size_t k = 0; k < stops.size(); ++k) {
    const double velocity = -sign(run.scene.stops[stops[k]].side) * closing[k];
    emit(run, EventKind::impact, stops[k], velocity, -run.scene.restitution * velocity, false,
         recorders...);
  }
  for (std::size_t stop : stops)
    if (run.state.stops[stop].speed == 0.0) settle(run, stop, recorders...);
  if (run.scene.beta > 0.0 && !run.state.mode->closed.empty())
    for (std::size_t stop : stops)
      release_by_jump(run, static_cast<std::size_t>(run.scene.stops[stop].mass - 1), recorders...);

  // Chatter: not where r = 0 (one impact stops the mass) and not where r = 1 (it never ends).
  const double since_last = run.since_impact;
  run.since_impact = 0.0;
  run.flight_guess = std::numeric_limits<double>::infinity();
  if (run.state.mode != before || run.scene.restitution == 0.0 || run.scene.restitution == 1.0) {
    run.chatter.size = 0;
    return;
  }
  double longest = 0.0, press = 0.0;
  for (std::size_t stop : stops) {
    const OpenStop<D> &open = open_stop(run.state, stop);
    press = open.press(run.state.value, run.state.slope);
    const double guess = press > 0.0
                             ? 2.0 * run.state.stops[stop].speed * run.scene.mass[open.mass] / press
                             : std::numeric_limits<double>::infinity();
    longest = std::max(longest, guess);
  }
  run.flight_guess = 1.4 * longest;
  if (!(longest * run.state.mode->fastest < 1.0)) {
    run.chatter.size = 0;
    return;
  }
  const bool new_node = extend(run.chatter, run.state, stops, since_last, run.stride);
  if (new_node) ++run.counters.chatter_nodes;
  const double now = time_of(run.state.now, run.clock);
  const double room =
      std::min(elapsed(run.state.now, run.end, run.clock), next_sample(recorders...) - now);
  take_chatter_limit(run, new_node, press, room, recorders...);
}

template <int D>
double choose_span(const Run<D> &run, double remaining) {
  const double fastest = fastest_in_motion(*run.state.mode, run.state.value, run.state.slope);
  const double longest = fastest > 0.0 ? max_reach / fastest : remaining;
  return std::min({remaining, longest, run.flight_guess});
}

template <int D, class... Recorders>
Outcome simulate_lanes(const Scene &scene, const MotionState &start, double until,
                       const RunOptions &options, Recorders &...recorders) {
  const Clock clock(scene.omega);
  Run<D> run{scene, options, clock, instant_at(until, clock), {}};
  run.stride =
      scene.restitution > 0.0 && scene.restitution < 1.0 ? chatter_stride(scene.restitution) : 1;
  run.last_speed.assign(scene.stops.size(), 0.0);
  run.falling.assign(scene.stops.size(), 0);
  run.period_start = run.state.now = start.instant;
  set_lanes(run.state, scene, run.modes.enter(scene, start.held, run.counters), start);
  run.guard_period = scene.omega > 0.0 ? clock.period : until;
  run.state.stops.resize(scene.stops.size());
  for (std::size_t k = 0; k < scene.stops.size(); ++k) {
    const Stop &stop = scene.stops[k];
    const auto i = static_cast<Eigen::Index>(stop.mass - 1);
    const double sigma = sign(stop.side), gap = sigma * (stop.position - start.displacement(i));
    run.state.stops[k] = {gap, -sigma * start.velocity(i), 0, 0.0};
    if (gap == 0.0)
      run.state.stops[k] = {0.0, -sigma * start.velocity(i), 1, -sigma * start.velocity(i)};
  }
  for (std::size_t k = 0; k < scene.stops.size(); ++k)
    if (start.held[static_cast<std::size_t>(scene.stops[k].mass - 1)] == 0 &&
        run.state.stops[k].gap == 0.0 && run.state.stops[k].speed == 0.0)
      settle(run, k, recorders...);

  while (true) {
    const double remaining = elapsed(run.state.now, run.end, clock);
    if (!(remaining > 0.0)) break;
    const ContactMode<D> &mode = *run.state.mode;
    if (mode.open.empty() && mode.closed.empty()) {  // no stops: nothing can happen
      sample_flight(run, remaining, recorders...);
      const State<D> from = run.state;
      flow(mode, scene, from.value, from.slope, remaining, run.state.value, run.state.slope);
      ++run.counters.modal_evaluations;
      run.state.now = run.end;
      break;
    }
    const double span = choose_span(run, remaining);
    run.flight_guess = std::numeric_limits<double>::infinity();
    expand(mode, run.state.value, run.state.slope, span, run.flight.expansion, run.counters);
    find_first_event(run.state, run.flight, run.counters);
    const FirstEvent &event = run.flight.event;
    sample_flight(run, event.u * span, recorders...);
    move_to(run.state, run.flight, event.u, scene, clock);
    run.since_impact += event.u * span;
    if (event.kind == Happening::nothing && span == remaining) run.state.now = run.end;

    switch (event.kind) {
      case Happening::nothing:
        break;
      case Happening::impact:
        handle_impact(run, recorders...);
        break;
      case Happening::press:
        stick_at(run, event.stops.front(), recorders...);
        break;
      case Happening::release: {
        const std::size_t stop = event.stops.front();
        const double m = scene.mass[static_cast<std::size_t>(scene.stops[stop].mass - 1)];
        release_at(run, stop, 3, -event.force_slope / (span * m), recorders...);
        break;
      }
      case Happening::force_graze:
        run.state.stops[event.stops.front()].zeros = 1;
        break;
    }
  }
  return {physical(run.state, scene), time_of(run.state.now, clock), run.counters};
}

}  // namespace detail

// Runs `scene` from `start` to time `until` (non-dimensional) and tells `recorders` what they ask
// for. Throws std::invalid_argument for a scene that `check` rejects, std::runtime_error (with the
// state) when the impacts of one period exceed the stated limit.
template <class... Recorders>
Outcome simulate_from(const Scene &scene, const MotionState &start, double until,
                      const RunOptions &options, Recorders &...recorders) {
  check(scene);
  // Two masses under forcing, the paper's case, get lanes of fixed size; the code is the same. The
  // fixed lanes have no room for a strongly damped mode split in two (the bound is Gershgorin's).
  double stiffest = 0.0;
  for (std::size_t i = 0; i < scene.mass.size(); ++i)
    stiffest = std::max(
        stiffest,
        2.0 * (scene.stiffness[i] + (i + 1 < scene.mass.size() ? scene.stiffness[i + 1] : 0.0)) /
            scene.mass[i]);
  if (scene.masses() == 2 && scene.forced() && !detail::strongly_damped(scene.beta, stiffest))
    return detail::simulate_lanes<4>(scene, start, until, options, recorders...);
  return detail::simulate_lanes<Eigen::Dynamic>(scene, start, until, options, recorders...);
}

// The same from the scene's own initial state at t = 0.
template <class... Recorders>
Outcome simulate(const Scene &scene, double until, const RunOptions &options,
                 Recorders &...recorders) {
  check(scene);
  return simulate_from(scene, start_of(scene), until, options, recorders...);
}

}  // namespace vibro_impact
