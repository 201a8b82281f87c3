// What the panels of the paper show: displacements across a window, and the hold force on mass 1
// (the paper's F2, Eq. 20) over one settled forcing period.
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "reference/scenes/paper_scenes.hpp"
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

// Sticking phases of mass 1 (counted from 1) with the hold force along them; times within the
// period.
inline std::vector<HoldForceRecorder::Row> hold_force_rows(const Scene &scene) {
  const Clock clock(scene.omega);
  HoldForceRecorder force;
  force.mass = 1;
  force.from = paper::figure4_settling_periods * clock.period;
  force.to = force.from + clock.period;
  force.every = 0.001;
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
