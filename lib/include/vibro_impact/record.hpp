// The moments that a run reports, and small recorders that collect them.
//
// The concept `Recorder` in recorder.hpp says which members a recorder has. A run calls only these
// members, and computes and stores nothing that no recorder asks for. All quantities are
// non-dimensional.
#pragma once

#include <cstddef>
#include <vector>

#include "event.hpp"
#include "recorder.hpp"
#include "scene.hpp"

namespace vibro_impact {

// The motion at one time, while a run reports it to a recorder. At an event it is the motion just
// after the event: impacts of several masses at one instant are all applied before the first is
// reported. Event::velocity_before has the velocity before an impact. A displacement or velocity is
// computed when it is asked for, as a sum over all modes. A moment cannot be kept or copied; a
// recorder keeps the numbers. Masses count from 1. The functions throw std::invalid_argument for a
// mass that the chain does not have.
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
  // The force of the neighbours and the forcing on a held mass, F_p of Eqs. 12-13, positive towards
  // +x. It is NaN for a free mass.
  virtual double hold_force(int mass) const = 0;
};

// Records every event from time `from` on.
struct EventRecorder {
  double from = 0.0;
  std::vector<Event> events = {};

  void event(const Event &event, const Moment &);
  void check(const Scene &scene) const;
};

// Records the velocities (towards +x) of one mass just before its impacts, from time `from` on.
struct ImpactVelocityRecorder {
  int mass = 1;
  double from = 0.0;
  std::vector<double> velocities = {};

  void event(const Event &event, const Moment &);
  void check(const Scene &scene) const;
};

// The time of sample number `taken`, counted from 0, of the times from, from + every, ... up to
// `to`. The last may be beyond `to` by rounding and is then `to`. Returns infinity after the last.
double sample_time(double from, double to, double every, std::size_t taken);

// Records the displacements of all masses at from, from + every, ... up to `to`. `displacements`
// has N numbers for each time, one time after another.
struct SampleRecorder {
  double from = 0.0, to = 0.0, every = 0.0;
  std::vector<double> times = {}, displacements = {};

  double next_time() const;
  void sample(const Moment &moment);
  void check(const Scene &scene) const;
};

}  // namespace vibro_impact
