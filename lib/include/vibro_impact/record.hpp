// What a run reports, composed by the caller from small recorders.
//
// A recorder (the concept `Recorder` in recorder.hpp) has one or more members of a fixed form. A
// run calls only what its recorders have; nothing is computed or stored that none asked for.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "event_kind.hpp"
#include "instant.hpp"
#include "recorder.hpp"
#include "scene.hpp"

namespace vibro_impact {

// The stuck masses of a contact mode as `-`, `1`, `2`, `1+2`.
std::string contact_mode_name(const Held &held);

// One event of one mass; simultaneous ones are consecutive events with the same instant.
struct Event {
  EventKind kind = EventKind::impact;
  int stop = 1;  // from 1, as the masses: see stop_of
  int mass = 1;
  Side side = Side::upper;
  Instant instant;
  double time = 0.0;
  double velocity_before = 0.0, velocity_after = 0.0;  // of an impact
  int falling = 0;         // impacts at this stop before this one, each slower than the one before
  bool by_a_jump = false;  // a release by a neighbour's impact, or a start: at no root of the force
  Held held;               // contact mode after the event
};

// The stop of an event of this scene.
inline const Stop &stop_of(const Scene &scene, const Event &event) {
  return scene.stops[static_cast<std::size_t>(event.stop - 1)];
}

// The motion at one time, while a run reports it to a recorder: what is asked for is computed then,
// one displacement or velocity in a sum over all modes. It cannot be kept or copied; keep the
// numbers. `mass` counts from 1; std::invalid_argument for a mass the chain does not have.
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
  // Force of the neighbours and the forcing on a held mass (Eqs. 12-13, F_p; towards +x); NaN for a
  // mass that is free.
  virtual double hold_force(int mass) const = 0;
};

// Every event from time `from` on.
struct EventRecorder {
  double from = 0.0;
  std::vector<Event> events = {};

  void event(const Event &event, const Moment &);
  void check(const Scene &scene) const;
};

// Impact velocities (just before the impact) of one mass, from time `from` on: no trajectory.
struct ImpactSpeedRecorder {
  int mass = 1;
  double from = 0.0;
  std::vector<double> velocities = {};

  void event(const Event &event, const Moment &);
  void check(const Scene &scene) const;
};

// The time of sample `taken` (from 0) at from, from + every, ... up to `to`, the end to within
// rounding; infinite when there is none.
double sample_time(double from, double to, double every, std::size_t taken);

// Displacements of all masses at from, from + every, ... up to `to`; row-major, one row per time.
struct SampleRecorder {
  double from = 0.0, to = 0.0, every = 0.0;
  std::vector<double> times = {}, displacements = {};

  double next_time() const;
  void sample(const Moment &moment);
  void check(const Scene &scene) const;
};

}  // namespace vibro_impact
