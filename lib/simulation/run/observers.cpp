#include "observers.hpp"

#include <algorithm>
#include <cmath>

#include "events_at_an_instant.hpp"
#include "simulation/chain/require.hpp"

namespace vibro_impact::detail {

namespace {

class MomentOfMotion final : public Moment {
 public:
  MomentOfMotion(const Motion &motion, const Instant &instant_of_motion, const Clock &clock)
      : Moment(instant_of_motion, time_of(instant_of_motion, clock)), motion_(motion) {
  }
  int masses() const override {
    return static_cast<int>(motion_.mode->held.size());
  }
  double displacement(int mass) const override {
    return detail::displacement(motion_, index_of(mass));
  }
  double velocity(int mass) const override {
    return detail::velocity(motion_, index_of(mass));
  }
  double hold_force(int mass) const override {
    const std::size_t index = index_of(mass);
    for (const Contact &contact : motion_.mode->contacts)
      if (contact.held && contact.mass == index) return contact.sigma * evaluate(contact, motion_);
    return std::numeric_limits<double>::quiet_NaN();
  }

 private:
  const Motion &motion_;

  std::size_t index_of(int mass) const {
    require_mass(mass, masses());
    return static_cast<std::size_t>(mass - 1);
  }
};

}  // namespace

void report_event(Run &run, EventKind kind, std::size_t stop, ImpactVelocities velocities,
                  bool by_a_jump, Recorders recorders) {
  if (run.progress.inside_chatter || recorders.empty()) return;
  if (run.motion.now < run.progress.begin) return;  // other options resolve a chatter further
  const Stop &stop_of_event = run.scene().stops[stop];
  Event &event = run.scratch.event;
  event.kind = kind;
  event.stop = static_cast<int>(stop) + 1;
  event.mass = stop_of_event.mass;
  event.side = stop_of_event.side;
  event.instant = run.motion.now;
  event.velocity_before = velocities.before;
  event.velocity_after = velocities.after;
  event.falling = run.stops[stop].falling;
  event.by_a_jump = by_a_jump;
  event.held = run.motion.mode->held;
  const MomentOfMotion moment(run.motion, event.instant, run.problem.clock);
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

bool report_sample(Run &run, double time, Recorders recorders) {
  const Clock &clock = run.problem.clock;
  const MomentOfMotion moment(run.scratch.sampled, instant_at(time, clock), clock);
  bool done = false;
  for (Recorder *recorder : recorders) {
    if (recorder->next_time() > time) continue;
    recorder->sample(moment);
    if (recorder->done()) {
      done = true;
      continue;
    }
    const double next = recorder->next_time();
    require(next > time, "next_time = ", next, " after the sample at ", time, ": must be later");
  }
  run.progress.next_sample = next_sample(recorders);
  return done;
}

}  // namespace vibro_impact::detail
