// What the panels of the paper show: displacements across a window, and the hold force on mass 1
// (the paper's F2, Eq. 20) over one settled forcing period.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "reference/paper_scenes.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace vibro_impact::figures {

// A run shown as displacement against time resolves all chatter that can be seen.
inline const RunOptions all_visible_chatter{.resolve_chatter = paper::slowest_impact_shown};

// Samples both masses across the window of a panel.
inline SampleRecorder samples_across(const paper::AxisBox &box, double every) {
  return {.from = box.from, .to = box.to, .every = every};
}

struct Range {
  double lowest = std::numeric_limits<double>::infinity();
  double highest = -std::numeric_limits<double>::infinity();

  void include(double value) {
    lowest = std::min(lowest, value);
    highest = std::max(highest, value);
  }
};

// The displacements of the given mass, or of both (0).
inline Range range_of(const SampleRecorder &samples, int mass = 0) {
  Range range;
  for (std::size_t i = 0; i < samples.displacements.size(); ++i)
    if (mass == 0 || static_cast<int>(i % 2) == mass - 1) range.include(samples.displacements[i]);
  return range;
}

// The samples of both masses as a table t, x1, x2.
inline Table displacement_table(const SampleRecorder &samples) {
  Table table("t,x1,x2");
  for (std::size_t i = 0; i < samples.times.size(); ++i)
    table.row(samples.times[i], samples.displacements[2 * i], samples.displacements[2 * i + 1]);
  return table;
}

// The displacements of a scene across the window of a panel.
inline Table displacements(const Scene &scene, const paper::AxisBox &box, double every) {
  SampleRecorder samples = samples_across(box, every);
  require_complete(simulate(scene, samples.to, all_visible_chatter, samples));
  return displacement_table(samples);
}

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
    if (event.mass != mass || event.time < from || event.time > to) return;
    if (event.kind == EventKind::stick)
      rows.push_back({event.time, moment.hold_force(mass), ++phases});
    else if (event.kind == EventKind::release && !event.by_a_jump)
      rows.push_back({event.time, 0.0, phases});  // released at a root of the force
  }
};

// Sticking phases of mass 1 (counted from 1) with the hold force along them; times within the
// period.
inline std::vector<HoldForceRecorder::Row> hold_force_rows(const Scene &scene) {
  const Clock clock(scene.omega);
  const double from = paper::figure4_settling_periods * clock.period;
  HoldForceRecorder force{.mass = 1, .from = from, .to = from + clock.period, .every = 0.001};
  require_complete(simulate(scene, force.to, {}, force));
  for (HoldForceRecorder::Row &row : force.rows) row.time = instant_at(row.time, clock).phase;
  return force.rows;
}

inline Table hold_force(const Scene &scene) {
  Table table("phase,t,F2");
  for (const HoldForceRecorder::Row &row : hold_force_rows(scene))
    table.row(row.phase, row.time, row.force);
  return table;
}

}  // namespace vibro_impact::figures
