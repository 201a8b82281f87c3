// What one run carries from event to event, and how it tells the recorders.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "simulation/chain/forces.hpp"
#include "simulation/chain/require.hpp"
#include "simulation/chatter/chatter.hpp"
#include "simulation/flight/first_event.hpp"
#include "simulation/stops/rest.hpp"
#include "vibro_impact/simulate.hpp"

namespace vibro_impact {

template <int D>
struct Run {
  const Scene &scene;
  const RunOptions &options;
  std::span<const RecorderRef> recorders;
  Clock clock{scene.omega};
  double scene_rate = rate_of(scene);
  Instant end = {};
  Modes<D> modes = {};
  State<D> state = {};
  State<D> at_limit = {};  // of a chatter
  State<D> at_end = {};    // the state at the end, once known: on the flight from `state`
  State<D> between = {};   // at a sample
  State<D> before = {};    // while a chatter is looked into, with `chatter_before`
  Flight<D> flight = {};
  Chatter<D> chatter = {}, chatter_before = {};
  Counters counters = {};
  // In which impacts are counted: the forcing period.
  double window = scene.forced() && scene.omega > 0.0 ? clock.period : 6.3 / scene_rate;
  bool silent = false;  // a motion is looked at in between: nothing is told but samples
  bool over = false;    // the end is reached, a recorder is done, or the run is given up
  Ending ending = Ending::reached;
  std::string reason = {};
  std::vector<std::size_t> hits = {}, roots = {};  // contacts of the event at hand
  Question question = {};
  MotionState motion = {};  // at the instant at hand
  Event event = {};         // told, its storage reused
};

// A recorder may ask the run to end.
template <int D>
void ask_whether_done(Run<D> &run, const RecorderRef &ref) {
  if (!ref.done || !ref.done()) return;
  run.over = true;
  run.ending = Ending::stopped;
}

template <int D>
void give_up(Run<D> &run, std::string reason) {
  run.over = true;
  run.ending = Ending::given_up;
  run.reason = std::move(reason);
}

// The motion in a state.
template <int D>
class MomentOf final : public Moment {
 public:
  MomentOf(const State<D> &state, const Instant &at, const Clock &clock)
      : Moment(at, time_of(at, clock)), state_(state) {
  }
  int masses() const override {
    return static_cast<int>(state_.mode->held.size());
  }
  double displacement(int mass) const override {
    require_mass(mass, masses());
    return state_.mode->equilibrium(mass - 1) +
           state_.mode->shape.row(mass - 1).dot(state_.value.matrix());
  }
  double velocity(int mass) const override {
    require_mass(mass, masses());
    return state_.mode->shape.row(mass - 1).dot(state_.slope.matrix());
  }
  double hold_force(int mass) const override {
    require_mass(mass, masses());
    for (const Contact<D> &contact : state_.mode->contacts)
      if (contact.held && contact.mass + 1 == static_cast<std::size_t>(mass))
        return contact.sigma * contact.watched(state_.value, state_.slope);
    return std::numeric_limits<double>::quiet_NaN();
  }

 private:
  const State<D> &state_;
};

// Tells of an event at a stop; velocities of an impact as told.
template <int D>
void tell(Run<D> &run, EventKind kind, std::size_t stop, double before, double after,
          bool by_a_jump) {
  if (run.silent || run.recorders.empty()) return;
  const State<D> &state = run.state;
  Event &event = run.event;
  event.kind = kind;
  event.stop = stop;
  event.mass = run.scene.stops[stop].mass;
  event.side = run.scene.stops[stop].side;
  event.instant = state.now;
  event.velocity_before = before;
  event.velocity_after = after;
  event.falling = state.stops[stop].falling;
  event.by_a_jump = by_a_jump;
  event.held = state.mode->held;
  const MomentOf<D> moment(state, event.instant, run.clock);
  event.time = moment.time;
  for (const RecorderRef &ref : run.recorders) {
    if (!ref.event) continue;
    ref.event(event, moment);
    ask_whether_done(run, ref);
  }
}

template <int D>
double next_sample(const Run<D> &run) {
  double next = std::numeric_limits<double>::infinity();
  for (const RecorderRef &ref : run.recorders)
    if (ref.sample) {
      const double time = ref.next_time();
      require(!std::isnan(time), "next_time = ", time, ": must be a time");
      next = std::min(next, time);
    }
  return next;
}

// Serves the sample times up to tau after the state, on whose path it moves.
template <int D>
void sample_flight(Run<D> &run, double tau) {
  constexpr double never = std::numeric_limits<double>::infinity();
  for (double next = next_sample(run); next < never && !run.over; next = next_sample(run)) {
    const Instant instant = instant_at(next, run.clock);
    const double since = elapsed(run.state.now, instant, run.clock), after = std::max(0.0, since);
    if (after > tau) return;
    require(since >= -16.0 * std::numeric_limits<double>::epsilon() * next, "next_time = ", next,
            ": lies before the motion, which is at t = ", time_of(run.state.now, run.clock));
    State<D> &between = run.between;
    between = run.state;
    move_lanes(between, run.scene, run.clock, run.flight.path, after);
    ++run.counters.modal_evaluations;
    const MomentOf<D> moment(between, instant, run.clock);
    for (const RecorderRef &ref : run.recorders) {
      if (!ref.sample || ref.next_time() > next) continue;
      ref.sample(moment);
      ask_whether_done(run, ref);
      if (run.over) continue;
      const double then = ref.next_time();
      require(then > next, "next_time = ", then, " after the sample at ", next, ": must be later");
    }
    if (run.over) {
      run.at_end = between;
      read_gaps(run.at_end);
    }
  }
}

}  // namespace vibro_impact
