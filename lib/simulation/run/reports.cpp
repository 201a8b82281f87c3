#include "reports.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "endings.hpp"
#include "simulation/chain/require.hpp"

namespace vibro_impact::detail {

namespace {

// The moment of a motion of the run.
class MomentOfMotion final : public Moment {
 public:
  MomentOfMotion(const Run &run, const Motion &motion, const Instant &at)
      : Moment(at, time_of(at, run.chain().clock)), run_(run), motion_(motion) {
  }
  int masses() const override {
    return run_.scene().masses();
  }
  double displacement(int mass) const override {
    const std::size_t i = index_of(mass);
    const Chain &chain = run_.chain();
    const double place = motion_.x[i].hi,
                 inside = std::clamp(place, chain.lowest[i], chain.highest[i]);
    if (place == inside) return place;
    const double terms = std::abs(inside) + motion_.x_terms[i];
    return is_rounding_at_stop(std::abs(place - inside), terms, largest_terms(chain, motion_, time))
               ? inside
               : place;
  }
  double velocity(int mass) const override {
    return motion_.v[index_of(mass)].hi;
  }
  double hold_force(int mass) const override {
    const std::size_t i = index_of(mass);
    if (motion_.mode->held[i] == 0) return std::numeric_limits<double>::quiet_NaN();
    return rounded(force_at_rest(run_.chain(), i, motion_));
  }
  ImpactSum unreported(int stop) const override {
    require(stop >= 1 && static_cast<std::size_t>(stop) <= run_.stops.size(), "stop ", stop,
            ": the chain has ", run_.stops.size(), " stops");
    return run_.stops[static_cast<std::size_t>(stop - 1)].unreported;
  }
  MotionState state() const {
    return state_at(*this, motion_.mode->held);
  }

 private:
  const Run &run_;
  const Motion &motion_;

  std::size_t index_of(int mass) const {
    require_mass(mass, masses());
    return static_cast<std::size_t>(mass - 1);
  }
};

// The motion at a time `tau` of the step or long flight of the run. The rounding of a sample may
// put `tau` below 0, which is the start. It is valid until the next one.
const Motion &motion_at(Run &run, const Real &tau) {
  if (run.long_flight.is_under_way())
    return run.long_flight.at(run.chain(), tau.hi > 0.0 ? tau : Real(0.0));
  Motion &motion = run.scratch.motion;
  motion = run.motion;
  if (tau.hi > 0.0) move_along(run.chain(), run.scratch.step.table, tau.hi, motion);
  return motion;
}

// Reports this moment as the sample at this time to the recorders that have asked for it. Returns
// true when one of them is done.
bool report_sample(Run &run, const Moment &moment, double time, Recorders recorders) {
  bool any_done = false;
  for (Recorder *recorder : recorders) {
    if (recorder->next_time() > time) continue;
    recorder->sample(moment);
    if (recorder->done()) {
      any_done = true;
      continue;
    }
    const double next = recorder->next_time();
    require(next > time, "next_time = ", next, " after the sample at ", time, ": must be later");
  }
  run.progress.next_sample = next_sample(recorders);
  return any_done;
}

// The time, as it is reported, of the instant `tau` after the motion of the run.
double time_after(const Run &run, const Real &tau) {
  TwofoldInstant then = run.motion.now;
  pass(tau, run.chain().clock, then);
  return time_of(then.rounded(), run.chain().clock);
}

// Reports the samples up to the time `last`, with the motion no later than `tau`.
void sample_up_to(Run &run, double last, const Real &tau, Recorders recorders) {
  while (run.progress.next_sample <= last) {
    const double next = run.progress.next_sample;
    require(next >= run.time(), "next_time = ", next,
            ": lies before the motion, which is at t = ", run.time());
    const Instant at = instant_at(next, run.chain().clock);
    Real since = run.time_until(at);
    if (tau < since) since = tau;
    ++run.counters.states_computed;
    const MomentOfMotion moment(run, motion_at(run, since), at);
    if (!report_sample(run, moment, next, recorders)) continue;
    run.progress.last = moment.state();
    return stop_run(run, Ending::stopped);
  }
}

}  // namespace

double next_sample(Recorders recorders) {
  double next = infinity;
  for (const Recorder *recorder : recorders) {
    const double time = recorder->next_time();
    require(!std::isnan(time), "next_time = ", time, ": must be a time");
    next = std::min(next, time);
  }
  return next;
}

void report_impact(Run &run, std::size_t stop, double closing, double leaving,
                   Recorders recorders) {
  const ImpactSum taken = taken_by_impact(run.chain(), stop, closing, leaving);
  if (run.limit.is_ahead) {
    if (!(closing >= run.limit.slowest)) {
      run.stops[stop].unreported += taken;
      return;
    }
    run.limit.unreported -= taken;
  }
  const double sigma = run.chain().stops[stop].sigma;
  report_event(run, EventKind::impact, stop, sigma * closing, -sigma * leaving, false, taken,
               recorders);
}

void report_event(Run &run, EventKind kind, std::size_t stop, double before, double after,
                  bool by_a_jump, const ImpactSum &taken, Recorders recorders) {
  if (recorders.empty()) return;
  const Stop &stop_of_event = run.scene().stops[stop];
  Event &event = run.scratch.event;
  event.kind = kind;
  event.stop = static_cast<int>(stop) + 1;
  event.mass = stop_of_event.mass;
  event.side = stop_of_event.side;
  event.instant = run.motion.now.rounded();
  event.velocity_before = before;
  event.velocity_after = after;
  event.taken = taken;
  event.falling = run.stops[stop].falling;
  event.by_a_jump = by_a_jump;
  event.held = run.motion.mode->held;
  const MomentOfMotion moment(run, run.motion, event.instant);
  event.time = moment.time;
  for (Recorder *recorder : recorders) {
    recorder->event(event, moment);
    if (recorder->done()) stop_run(run, Ending::stopped);
  }
  run.progress.next_sample = next_sample(recorders);
}

void sample(Run &run, const Real &tau, Recorders recorders) {
  if (run.progress.next_sample < infinity) sample_up_to(run, time_after(run, tau), tau, recorders);
}

void end_at_time(Run &run, Recorders recorders) {
  const Real tau = run.time_until(run.progress.end);
  sample_up_to(run, time_of(run.progress.end, run.chain().clock), tau, recorders);
  if (run.progress.ending) return;
  const Motion &motion = motion_at(run, tau);
  run.progress.last = MomentOfMotion(run, motion, run.progress.end).state();
  if (run.long_flight.is_under_way()) ++run.counters.states_computed;
  check_motion(run, motion);
  stop_run(run, Ending::reached);
}

MotionState state_of(const Run &run) {
  return MomentOfMotion(run, run.motion, run.motion.now.rounded()).state();
}

}  // namespace vibro_impact::detail
