/// \file
/// The moments that a run reports, and small recorders that collect them. A run computes no state
/// and stores no event that no recorder asks for. All quantities are non-dimensional.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "event.hpp"
#include "scene.hpp"

namespace vibro_impact {

/// The motion at one time, while a run reports it to a recorder. At an event it is the motion just
/// after the event: impacts of several masses at one instant are all applied before the first is
/// reported. Event::velocity_before has the velocity before an impact. A moment cannot be kept or
/// copied; a recorder keeps the numbers. Masses count from 1. The functions throw
/// std::invalid_argument for a mass that the chain does not have.
class Moment {
 public:
  Instant instant;
  double time = 0.0;

  Moment(const Instant &at, double time_of_it) : instant(at), time(time_of_it) {
  }
  Moment(const Moment &) = delete;
  Moment &operator=(const Moment &) = delete;
  virtual ~Moment() = default;

  virtual int masses() const = 0;
  virtual double displacement(int mass) const = 0;
  virtual double velocity(int mass) const = 0;
  /// The force on a held mass without the reaction of its stop, F_p of Eqs. 12-13, positive towards
  /// +x: of its springs and dampers, the forcing and the constant force. It is NaN for a free mass.
  virtual double hold_force(int mass) const = 0;
  /// The sums of the impacts at a stop (from 1) up to this moment that no event has reported yet.
  /// They are impacts of a chatter, and the event at its limit reports them. Else they are zero.
  /// The impulses of all events and of this sum balance the momentum up to this moment.
  virtual ImpactSum unreported(int stop) const = 0;
};

/// The state at a moment of a run, which is in this contact mode.
MotionState state_at(const Moment &moment, const Held &held);

/// A recorder is an object of a class that derives from Recorder and overrides some of its members,
/// which a run calls. An exception that a member throws ends the run and reaches the caller. The
/// state of the simulation is then unspecified.
struct Recorder {
  virtual ~Recorder() = default;

  /// A run calls `check` before it begins. It throws std::invalid_argument to refuse the scene.
  virtual void check(const Scene &) const {
  }
  /// A run calls `event` at every event. Of the infinitely many impacts of a chatter that is
  /// carried to its limit, it reports those that were resolved to find the limit, and those that a
  /// recorder asks for. The event at the limit has the sums of the others.
  virtual void event(const Event &, const Moment &) {
  }
  /// The least speed of the impacts that are to be reported. A run asks when it has found the
  /// limit of a chatter at the time `limit`, and after each impact before it; `first` is the speed
  /// of the first impact of this chatter. The impacts are then resolved first. The limit stays the
  /// same to the last bit. Infinity asks for no further impact. All recorders of a call hear the
  /// same events.
  virtual double slowest_impact([[maybe_unused]] double first,
                                [[maybe_unused]] double limit) const {
    return infinity;
  }
  /// A run calls `sample` at the time that `next_time` returns, and asks for the next time as it
  /// begins, after every event and after every sample. Each time must be later than the latest
  /// sample. Infinity asks for no sample. A sample at the time of an event has the motion before
  /// it, but where it was asked for in `event`, and at the time at which a run starts, the motion
  /// after it.
  virtual double next_time() const {
    return infinity;
  }
  virtual void sample(const Moment &) {
  }
  /// A run calls `done` after every event, and after every sample of this recorder. It ends at that
  /// time if `done` returns true.
  virtual bool done() const {
    return false;
  }
};

/// The speed, relative to the first impact of a chatter, down to which impacts are listed by
/// default.
constexpr double listed_share = 1e-4;

/// The speed down to which the impacts of a chatter are listed: `slowest`, or a share of the first.
inline double slowest_listed(const std::optional<double> &slowest, double first) {
  return slowest.value_or(listed_share * first);
}

/// Records every event from time `from` on. Impacts of a chatter are recorded down to the speed
/// `slowest`, or if it is empty down to `listed_share` of the first impact of the chatter. The
/// infinitely many slower ones are in the event at the limit.
struct EventRecorder : Recorder {
  double from;
  std::optional<double> slowest;
  std::vector<Event> events = {};

  explicit EventRecorder(double from_time = 0.0, std::optional<double> slowest_speed = {})
      : from(from_time), slowest(slowest_speed) {
  }
  void check(const Scene &scene) const override;
  double slowest_impact(double first, double limit) const override;
  void event(const Event &event, const Moment &) override;
};

/// The time of sample number `taken`, counted from 0, of the times from, from + every, ... up to
/// `to`. The last may be beyond `to` by rounding and is then `to`. Returns infinity after the last.
double sample_time(double from, double to, double every, std::size_t taken);

/// Records the displacements of all masses at from, from + every, ... up to `to`. `displacements`
/// has N numbers for each time, one time after another.
struct SampleRecorder : Recorder {
  double from, to, every;
  std::vector<double> times = {}, displacements = {};

  SampleRecorder(double from_time, double to_time, double every_time)
      : from(from_time), to(to_time), every(every_time) {
  }
  void check(const Scene &scene) const override;
  double next_time() const override;
  void sample(const Moment &moment) override;
};

}  // namespace vibro_impact
