#include "observers.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "simulation/chain/require.hpp"

namespace vibro_impact::detail {

namespace {

// The moment of a motion, whose hold forces are evaluated when they are asked for.
class MomentOfMotion final : public Moment {
 public:
  MomentOfMotion(const Run &run, const Motion &motion, const Instant &at)
      : Moment(at, time_of(at, run.problem.clock)), chain_(run.chain()), motion_(motion) {
  }
  int masses() const override {
    return static_cast<int>(chain_.masses);
  }
  double displacement(int mass) const override {
    const std::size_t i = index_of(mass);
    return std::clamp(motion_.x[i].hi, chain_.lowest[i], chain_.highest[i]);
  }
  double velocity(int mass) const override {
    return motion_.v[index_of(mass)].hi;
  }
  double hold_force(int mass) const override {
    const std::size_t i = index_of(mass);
    for (const Contact &contact : motion_.mode->contacts)
      if (contact.held && contact.mass == i)
        return contact.sigma * rounded(evaluate(chain_, contact, motion_).value);
    return std::numeric_limits<double>::quiet_NaN();
  }

 private:
  const Chain &chain_;
  const Motion &motion_;

  std::size_t index_of(int mass) const {
    require_mass(mass, masses());
    return static_cast<std::size_t>(mass - 1);
  }
};

}  // namespace

void stop_run(Run &run, Ending ending, std::string reason) {
  if (run.progress.over) return;
  run.progress.over = true;
  run.progress.ending = ending;
  run.progress.reason = std::move(reason);
}

void report_event(Run &run, EventKind kind, std::size_t stop, double before, double after,
                  bool by_a_jump, Recorders recorders) {
  if (run.progress.inside_chatter || recorders.empty()) return;
  const Stop &stop_of_event = run.scene().stops[stop];
  Event &event = run.scratch.event;
  event.kind = kind;
  event.stop = static_cast<int>(stop) + 1;
  event.mass = stop_of_event.mass;
  event.side = stop_of_event.side;
  event.instant = run.motion.now.rounded();
  event.velocity_before = before;
  event.velocity_after = after;
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

double next_sample(Recorders recorders) {
  double next = infinity;
  for (const Recorder *recorder : recorders) {
    const double time = recorder->next_time();
    require(!std::isnan(time), "next_time = ", time, ": must be a time");
    next = std::min(next, time);
  }
  return next;
}

const Motion &motion_at(Run &run, Real tau) {
  const Clock &clock = run.problem.clock;
  if (!(tau.hi > 0.0)) tau = 0.0;
  if (run.long_flight.is_under_way())
    return run.long_flight.at(run.chain(), clock, run.motion, tau);
  if (!(tau.hi > 0.0)) return run.motion;
  Motion &motion = run.scratch.motion;
  if (motion.x.empty()) clear(run.chain(), motion);
  // The step sets all else but the acceleration, of which nothing is reported.
  motion.now = run.motion.now;
  motion.turn = run.motion.turn;
  motion.turned = run.motion.turned;
  motion.mode = run.motion.mode;
  motion.x = run.motion.x;
  motion.v = run.motion.v;
  move_along(run.chain(), clock, run.scratch.flight.table, tau.hi, motion);
  return motion;
}

bool report_sample(Run &run, const Motion &motion, const Instant &at, double time,
                   Recorders recorders) {
  const MomentOfMotion moment(run, motion, at);
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

MotionState state_of(const Run &run, const Motion &motion, const Instant &at) {
  return state_at(MomentOfMotion(run, motion, at), motion.mode->held);
}

}  // namespace vibro_impact::detail
