// The hold force on mass 1 (the paper's F2, Eq. 20) over one settled forcing period.
#pragma once

#include <vector>

#include "reference/scenes/paper_scenes.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace vibro_impact::figures {

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
