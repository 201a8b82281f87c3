// Figures read these off runs: events, counts, extremes, displacements across a window, and
// sticking phases.
#pragma once

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

#include "reference/numbers/panels.hpp"
#include "reference/scenes/paper_scenes.hpp"
#include "vibro_impact/analysis/locate.hpp"
#include "vibro_impact/analysis/table.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace vibro_impact::figures {

struct Range {
  double lowest = infinity;
  double highest = -infinity;

  void include(double value) {
    lowest = std::min(lowest, value);
    highest = std::max(highest, value);
  }
};

// The first and the last of each run of neighbours among 0, every, 2 every, ... below `count` for
// which `holds` is true.
template <class Predicate>
std::vector<std::pair<std::size_t, std::size_t>> runs_where(const Predicate &holds,
                                                            std::size_t count,
                                                            std::size_t every = 1) {
  std::vector<std::pair<std::size_t, std::size_t>> runs;
  for (std::size_t i = 0; i < count; i += every) {
    if (!holds(i)) continue;
    if (runs.empty() || runs.back().second + every != i) runs.emplace_back(i, i);
    runs.back().second = i;
  }
  return runs;
}

// The displacement of one of two masses at a sample.
inline double displacement(const SampleRecorder &samples, std::size_t sample, int mass) {
  return samples.displacements[2 * sample + static_cast<std::size_t>(mass - 1)];
}

inline Range range_of(const SampleRecorder &samples, int mass) {
  Range range;
  for (std::size_t i = 0; i < samples.times.size(); ++i)
    range.include(displacement(samples, i, mass));
  return range;
}

// Events of a scene from its own start, from time `from` to `until`.
inline std::vector<Event> events_of(const Scene &scene, double from, double until,
                                    const RunOptions &options = {}) {
  EventRecorder recorder(from);
  require_complete(simulate(scene, until, options, recorder));
  return recorder.events;
}

// Number of times at which a mass comes to rest while the other one sticks.
inline double dual_sticks(const Scene &scene, double from, double until) {
  const std::vector<Event> events = events_of(scene, from, until);
  return static_cast<double>(std::ranges::count_if(events, [](const Event &event) {
    return event.kind == EventKind::stick && contact_mode_name(event.held) == "1+2";
  }));
}

// The sticking phases of a mass in four forcing periods of the motion that a scene settles to.
// Motions of period 1, 2 and 4 give the same count in every window.
inline int settled_sticking_phases(const Scene &scene, int mass) {
  return sticking_phases(scene, mass, paper::figure4_settling_periods, 4);
}

// The same of the motion followed to this scene from a motion that settles at another frequency.
inline int followed_sticking_phases(Scene scene, int mass, const MotionState &settled) {
  scene.displacement = settled.displacement;
  scene.velocity = settled.velocity;
  return settled_sticking_phases(scene, mass);
}

// A run shown as displacement against time resolves all chatter that can be seen.
inline const RunOptions all_visible_chatter{.limit_below_speed = paper::slowest_impact_shown};

// The samples of both masses as a table t, x1, x2.
inline Table displacement_table(const SampleRecorder &samples) {
  Table table("t,x1,x2");
  for (std::size_t i = 0; i < samples.times.size(); ++i)
    table.row(samples.times[i], displacement(samples, i, 1), displacement(samples, i, 2));
  return table;
}

// The displacements of a scene across the window of a panel.
inline Table displacements(const Scene &scene, const paper::AxisBox &box, double every) {
  SampleRecorder samples(box.from, box.to, every);
  require_complete(simulate(scene, samples.to, all_visible_chatter, samples));
  return displacement_table(samples);
}

// The impacts across the window of a panel: when, of which mass, and how fast.
inline Table impacts(const Scene &scene, const paper::AxisBox &box) {
  Table table("t,mass,speed");
  for (const Event &event : events_of(scene, box.from, box.to, all_visible_chatter))
    if (event.kind == EventKind::impact)
      table.row(event.time, event.mass, std::abs(event.velocity_before));
  return table;
}

// The parameters of the scenes that a figure shows, one row per panel.
inline Table parameters(const std::vector<Scene> &scenes) {
  Table table("omega,r,s1,s2");
  for (const Scene &scene : scenes)
    table.row(scene.omega, scene.restitution, scene.stops[0].position, scene.stops[1].position);
  return table;
}

// The sticking phases of one mass, counted from 1, and the gaps between them: at uniform times, at
// the stick and at the release the hold force on it (F_p of Eqs. 12-13) and the motion of another
// mass.
struct StickingPhaseRecorder : Recorder {
  struct Row {
    int phase;              // in a gap, that before it; 0 before the first
    std::string_view kind;  // stick, release, orbit between them, or gap
    double time;            // within the forcing period
    double force;           // zero at a release at a root of the force; NaN at any other, in a gap
    double x = 0.0, v = 0.0;  // of the other mass
  };
  int mass, other;  // other = 0: none
  double from, to, every;
  std::vector<Row> rows = {};
  int phase = 0;
  std::size_t asked = 0;

  StickingPhaseRecorder(int of_mass, int other_mass, double from_time, double to_time,
                        double every_time)
      : mass(of_mass), other(other_mass), from(from_time), to(to_time), every(every_time) {
  }
  double next_time() const override {
    return sample_time(from, to, every, asked);
  }
  void sample(const Moment &moment) override {
    ++asked;
    const double force = moment.hold_force(mass);
    add(std::isnan(force) ? "gap" : "orbit", force, moment);
  }
  void event(const Event &event, const Moment &moment) override {
    if (event.mass != mass || event.time < from || event.time > to) return;
    switch (event.kind) {
      case EventKind::impact:
        return;
      case EventKind::stick:
        ++phase;
        return add(name(event.kind), moment.hold_force(mass), moment);
      case EventKind::release:
        return add(name(event.kind), event.by_a_jump ? moment.hold_force(mass) : 0.0, moment);
    }
  }
  void add(std::string_view kind, double force, const Moment &moment) {
    rows.push_back({phase, kind, moment.instant.phase, force});
    if (other == 0) return;
    rows.back().x = moment.displacement(other);
    rows.back().v = moment.velocity(other);
  }
};

}  // namespace vibro_impact::figures
