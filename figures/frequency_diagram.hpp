// Diagrams like Figure 3: impact velocities against the forcing frequency, each motion from rest.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "reference/numbers/panels.hpp"
#include "reference/scenes/paper_scenes.hpp"
#include "vibro_impact/analysis/analysis.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace vibro_impact::figures {

// Frequencies from 0.25 to 0.7, both included, at equal distances.
inline Grid grid_of_figure3(std::size_t count) {
  const paper::AxisBox box = paper::panel("figure3a");
  return {paper::figure3(box.from), {{"omega", box.from, box.to, count}}};
}

// The distinct ones among `values`, sorted: those that agree to 1e-6 of their size, as the impacts
// of a periodic motion do from period to period, count as one.
inline std::vector<double> distinct(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const auto same = [](double a, double b) { return std::abs(a - b) <= 1e-6 * std::abs(a); };
  values.erase(std::unique(values.begin(), values.end(), same), values.end());
  return values;
}

// The motion from rest with its chatter impacts down to slowest_impact_shown.
inline OrbitRecord recorded_in_figure3(const Scene &scene) {
  return record_of(scene, {.settle = {.longest = paper::figure3_settling_periods},
                           .impacts = true,
                           .slowest = paper::slowest_impact_shown});
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

// The frequencies at which each mass with a stop sticks.
inline Table sticking(const Grid &grid, const std::vector<OrbitRecord> &records) {
  Table table("mass,omega");
  for (const Stop &stop : grid.scene.stops)
    for (std::size_t i = 0; i < records.size(); ++i)
      if (records[i].counts.sticks[static_cast<std::size_t>(stop.mass - 1)] > 0)
        table.row(stop.mass, grid.values(i).front());
  return table;
}

}  // namespace vibro_impact::figures
