// The points of Figure 3, for the test of the command that draws it.
#pragma once

#include <string>
#include <vector>

#include "figures/measures/runs.hpp"

namespace vibro_impact::figures {

// The motion from rest with its chatter impacts down to slowest_impact_shown.
inline OrbitRecord recorded_in_figure3(const Scene &scene) {
  return record_of(scene, recorded_of_figure3);
}

// The distinct impact velocities of a mass (from 1), the column v<mass>, at every frequency.
inline Table impact_velocities(const Grid &grid, const std::vector<OrbitRecord> &records,
                               int mass) {
  Table table("omega,v" + std::to_string(mass));
  for (std::size_t i = 0; i < records.size(); ++i) {
    std::vector<double> velocities;
    for (const Event &impact : records[i].impacts[static_cast<std::size_t>(mass - 1)])
      velocities.push_back(impact.velocity_before);
    for (const double v : distinct(velocities)) table.row(grid.values(i).front(), v);
  }
  return table;
}

}  // namespace vibro_impact::figures
