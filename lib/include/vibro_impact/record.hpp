// What a run reports, composed by the caller from small recorders.
//
// A recorder is any value with one or more of
//   void event(const Event &, const Moment &)          called at every event
//   double next_time() and void sample(const Moment &) called at the times it asks for, each later
//                                                      than the one before; infinite: no more
// and beside them, if it likes,
//   bool done()                 asked after each of these calls: true ends the run there; of a
//                               recorder that has this alone, asked after every flight
//   void check(const Scene &)   called before the run; throws std::invalid_argument
// A run calls only what its recorders have; nothing is computed or stored that none asked for.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "event_kind.hpp"
#include "instant.hpp"
#include "scene.hpp"

namespace vibro_impact {

// The stuck masses of a contact mode as `-`, `1`, `2`, `1+2`.
std::string contact_mode_name(const Held &held);

// One event of one mass; simultaneous ones are consecutive events with the same instant.
struct Event {
  EventKind kind = EventKind::impact;
  std::size_t stop = 0;  // index in Scene::stops
  int mass = 1;          // from 1
  Side side = Side::upper;
  Instant instant;
  double time = 0.0;
  double velocity_before = 0.0, velocity_after = 0.0;  // of an impact
  int falling = 0;         // impacts at this stop before this one, each slower than the one before
  bool by_a_jump = false;  // a release by a neighbour's impact, or a start: at no root of the force
  Held held;               // contact mode after the event
};

// The motion at one time, while a recorder is told of it: what is asked for is computed then. It
// cannot be kept or copied; keep the numbers. `mass` counts from 1; std::invalid_argument for a
// mass the chain does not have.
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

// A recorder as a run sees it; empty where it has no such member. Refers to the recorder.
struct RecorderRef {
  std::function<void(const Event &, const Moment &)> event = {};
  std::function<double()> next_time = {};
  std::function<void(const Moment &)> sample = {};
  std::function<bool()> done = {};
  std::function<void(const Scene &)> check = {};
};

template <class Recorder>
RecorderRef recorder_ref(Recorder &recorder) {
  constexpr bool takes_events = requires(const Event &event, const Moment &moment) {
    recorder.event(event, moment);
  };
  constexpr bool takes_samples = requires(const Moment &moment) {
    double{recorder.next_time()}, recorder.sample(moment);
  };
  constexpr bool is_asked = requires {
    bool{recorder.done()};
  };
  static_assert(takes_events || takes_samples || is_asked,
                "a recorder takes events or samples, or is asked whether it is done");
  RecorderRef ref;
  if constexpr (takes_events)
    ref.event = [&recorder](const Event &event, const Moment &moment) {
      recorder.event(event, moment);
    };
  if constexpr (takes_samples) {
    ref.next_time = [&recorder] { return recorder.next_time(); };
    ref.sample = [&recorder](const Moment &moment) { recorder.sample(moment); };
  }
  if constexpr (is_asked) ref.done = [&recorder] { return recorder.done(); };
  if constexpr (requires(const Scene &scene) { recorder.check(scene); })
    ref.check = [&recorder](const Scene &scene) { recorder.check(scene); };
  return ref;
}

}  // namespace vibro_impact
