// What a run reports, composed by the caller from small recorders.
//
// A recorder is any value with one or both of
//   void event(const Event &, const Moment &)       called at every event
//   double next_time() / void sample(const Moment &)  called at the times it asks for
// A run calls only what its recorders have; nothing is computed or stored that none asked for.
// `recorder_ref` turns a recorder into what the compiled run sees of it.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "motion.hpp"

namespace vibro_impact {

enum class EventKind { impact, stick, release };

inline const char *name(EventKind kind) {
  return kind == EventKind::impact ? "impact" : kind == EventKind::stick ? "stick" : "release";
}

// One event of one mass; simultaneous impacts are consecutive events with the same instant.
struct Event {
  EventKind kind = EventKind::impact;
  int mass = 1;  // from 1
  Side side = Side::upper;
  Instant instant;
  double time = 0.0;
  double velocity_before = 0.0, velocity_after = 0.0;
  Held held;               // contact mode after the event
  bool by_a_jump = false;  // a release forced by a neighbour's impact, not at a root of the force
};

// The stuck masses of a contact mode as `-`, `1`, `2`, `1+2`.
inline std::string contact_mode_name(const Held &held) {
  std::string text;
  for (std::size_t i = 0; i < held.size(); ++i)
    if (held[i] != 0) {
      if (!text.empty()) text.push_back('+');
      fmt::format_to(std::back_inserter(text), "{}", i + 1);
    }
  if (text.empty()) text.push_back('-');
  return text;
}

// A quantity of one mass (from 1), evaluated when it is asked for. Refers to the state of the run.
struct OfMass {
  const void *state;
  const void *scene;
  double (*at)(const void *state, const void *scene, int mass);

  double operator()(int mass) const {
    return at(state, scene, mass);
  }
};

// The motion at one time, while a recorder is told of it.
struct Moment {
  Instant instant;
  double time = 0.0;
  OfMass displacement, velocity;
  // Force of the neighbours and the forcing on a held mass (Eqs. 12-13, F_p; towards +x); NaN for a
  // mass that is free.
  OfMass hold_force;
};

// Every event from time `from` on.
struct EventRecorder {
  double from = 0.0;
  std::vector<Event> events = {};

  void event(const Event &event, const Moment &) {
    if (event.time < from) return;
    if (events.empty()) events.reserve(256);
    events.push_back(event);
  }
};

// Impact velocities (just before the impact) of one mass, from time `from` on: no trajectory.
struct ImpactSpeedRecorder {
  int mass = 1;
  double from = 0.0;
  std::vector<double> velocities = {};

  void event(const Event &event, const Moment &) {
    if (event.kind == EventKind::impact && event.mass == mass && event.time >= from)
      velocities.push_back(event.velocity_before);
  }
};

// The time of sample `taken` (from 0) at from, from + every, ... up to `to`, the end to within
// rounding; infinite when there is none.
inline double sample_time(double from, double to, double every, std::size_t taken) {
  const double next = from + every * static_cast<double>(taken);
  return next <= to * (1.0 + 4e-16) ? next : std::numeric_limits<double>::infinity();
}

// Displacements of all masses at from, from + every, ... up to `to`; row-major, one row per time.
struct SampleRecorder {
  double from = 0.0, to = 0.0, every = 0.0;
  int masses = 0;
  std::vector<double> times = {}, displacements = {};

  double next_time() const {
    return sample_time(from, to, every, times.size());
  }
  void sample(const Moment &moment) {
    times.push_back(moment.time);
    for (int i = 1; i <= masses; ++i) displacements.push_back(moment.displacement(i));
  }
};

// The hold force on one mass (F_p of Eqs. 12-13) at uniform times and at the ends of every sticking
// phase, from time `from` on. `phase` counts the sticking phases.
struct HoldForceRecorder {
  struct Row {
    double time, force;
    int phase;
  };
  int mass = 1;
  double from = 0.0, to = 0.0, every = 0.0;
  std::vector<Row> rows = {};
  int phases = 0;
  std::size_t asked = 0;

  double next_time() const {
    return sample_time(from, to, every, asked);
  }
  void sample(const Moment &moment) {
    ++asked;
    const double force = moment.hold_force(mass);
    if (!std::isnan(force)) rows.push_back({moment.time, force, phases});
  }
  void event(const Event &event, const Moment &moment) {
    if (event.mass != mass || event.kind == EventKind::impact || event.time < from ||
        event.time > to)
      return;
    if (event.kind == EventKind::stick) {
      ++phases;
      rows.push_back({event.time, moment.hold_force(mass), phases});
    } else if (!event.by_a_jump) {
      rows.push_back({event.time, 0.0, phases});  // released at a root of the force
    }
  }
};

}  // namespace vibro_impact
