#include "observers.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "simulation/chain/require.hpp"

namespace vibro_impact::detail {

namespace {

// The part of a moment that is the same on a step and at an event: what is held.
class MomentOfChain : public Moment {
 public:
  MomentOfChain(const Chain &chain, const ContactMode &mode, const Instant &at, const Clock &clock)
      : Moment(at, time_of(at, clock)), chain_(chain), mode_(mode) {
  }
  int masses() const override {
    return static_cast<int>(chain_.masses);
  }
  double displacement(int mass) const override {
    const std::size_t i = index_of(mass);
    return std::clamp(x(i), chain_.lowest[i], chain_.highest[i]);
  }
  double velocity(int mass) const override {
    return v(index_of(mass));
  }

 protected:
  const Chain &chain_;
  const ContactMode &mode_;

  virtual double x(std::size_t mass) const = 0;
  virtual double v(std::size_t mass) const = 0;
  std::size_t index_of(int mass) const {
    require_mass(mass, masses());
    return static_cast<std::size_t>(mass - 1);
  }
  const Contact *held_contact(std::size_t mass) const {
    for (const Contact &contact : mode_.contacts)
      if (contact.held && contact.mass == mass) return &contact;
    return nullptr;
  }
};

class MomentOfMotion final : public MomentOfChain {
 public:
  MomentOfMotion(const Chain &chain, const Motion &motion, const Instant &at, const Clock &clock)
      : MomentOfChain(chain, *motion.mode, at, clock), motion_(motion) {
  }
  double hold_force(int mass) const override {
    const Contact *contact = held_contact(index_of(mass));
    if (!contact) return std::numeric_limits<double>::quiet_NaN();
    return contact->sigma * rounded(evaluate(chain_, *contact, motion_).value);
  }

 private:
  const Motion &motion_;

  double x(std::size_t mass) const override {
    return motion_.x[mass].hi;
  }
  double v(std::size_t mass) const override {
    return motion_.v[mass].hi;
  }
};

// A displacement or velocity is read from the table of the step when it is asked for.
class MomentOfStep final : public MomentOfChain {
 public:
  MomentOfStep(const Chain &chain, const TaylorTable &table, const Motion &start, double tau,
               const Instant &at, const Clock &clock)
      : MomentOfChain(chain, *start.mode, at, clock),
        table_(table),
        start_(start),
        tau_(tau),
        clock_(clock) {
  }
  double hold_force(int mass) const override {
    Motion motion = start_;
    move_along(chain_, clock_, table_, tau_, motion);
    return MomentOfMotion(chain_, motion, instant, clock_).hold_force(mass);
  }

 private:
  const TaylorTable &table_;
  const Motion &start_;
  double tau_;
  const Clock &clock_;

  double x(std::size_t mass) const override {
    return displacement_at(table_, start_, mass, tau_);
  }
  double v(std::size_t mass) const override {
    return velocity_at(table_, start_, mass, tau_);
  }
};

// Calls `use` with the moment.
template <class Use>
auto with_moment(Run &run, const TimeOfFlight &at, const Use &use) {
  const Chain &chain = run.chain();
  const Clock &clock = run.problem.clock;
  if (at.in_long_flight)
    return use(MomentOfMotion(chain, run.long_flight.at(chain, clock, run.motion, at.tau),
                              at.instant, clock));
  return use(MomentOfStep(chain, run.scratch.flight.table, run.motion, rounded(at.tau), at.instant,
                          clock));
}

}  // namespace

void stop_run(Run &run, Ending ending, std::string reason) {
  if (run.progress.over) return;
  run.progress.over = true;
  run.progress.ending = ending;
  run.progress.reason = std::move(reason);
}

void report_event(Run &run, EventKind kind, std::size_t stop, ImpactVelocities velocities,
                  bool by_a_jump, Recorders recorders) {
  if (run.progress.inside_chatter || recorders.empty()) return;
  const Stop &stop_of_event = run.scene().stops[stop];
  Event &event = run.scratch.event;
  event.kind = kind;
  event.stop = static_cast<int>(stop) + 1;
  event.mass = stop_of_event.mass;
  event.side = stop_of_event.side;
  event.instant = run.motion.now.rounded();
  event.velocity_before = velocities.before;
  event.velocity_after = velocities.after;
  event.falling = run.stops[stop].falling;
  event.by_a_jump = by_a_jump;
  event.held = run.motion.mode->held;
  const MomentOfMotion moment(run.chain(), run.motion, event.instant, run.problem.clock);
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

bool report_sample(Run &run, double time, const TimeOfFlight &at, Recorders recorders) {
  const bool done = with_moment(run, at, [&](const Moment &moment) {
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
    return any_done;
  });
  run.progress.next_sample = next_sample(recorders);
  return done;
}

MotionState state_at(Run &run, const TimeOfFlight &at) {
  return with_moment(run, at, [&](const Moment &moment) {
    return vibro_impact::state_at(moment, run.motion.mode->held);
  });
}

MotionState state_of(const Run &run) {
  const MomentOfMotion moment(run.chain(), run.motion, run.motion.now.rounded(), run.problem.clock);
  return vibro_impact::state_at(moment, run.motion.mode->held);
}

}  // namespace vibro_impact::detail
