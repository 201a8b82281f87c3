// Diagrams like Figure 3: impact velocities against the forcing frequency, each motion from rest.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "reference/paper_scenes.hpp"
#include "vibro_impact/analysis/analysis.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace vibro_impact::figures {

// Frequencies from 0.25 to 0.7, both included, at equal distances.
inline std::vector<double> frequencies_of_figure3(int count) {
  const paper::AxisBox &box = paper::figure3a_box;
  std::vector<double> omegas;
  for (int i = 0; i < count; ++i)
    omegas.push_back(box.from + (box.to - box.from) * i / (count - 1));
  return omegas;
}

// The distinct ones among `values`, sorted: those that agree to 1e-6 of their size, as the impacts
// of a periodic motion do from period to period, count as one.
inline std::vector<double> distinct(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const auto same = [](double a, double b) { return std::abs(a - b) <= 1e-6 * std::abs(a); };
  values.erase(std::unique(values.begin(), values.end(), same), values.end());
  return values;
}

// What is recorded at a frequency: chatter impacts down to slowest_impact_shown, over `periods`
// forcing periods where the motion does not settle.
inline RecordOptions recorded_in_figure3(int periods) {
  RecordOptions options;
  options.settle.longest = paper::figure3_settling_periods;
  options.counted = periods;
  options.impact_velocities = true;
  options.slowest = paper::slowest_impact_shown;
  return options;
}

// What is recorded from rest at every frequency, in their order. `scene_at` gives the scene of a
// frequency; `advance` is called after each of them.
inline std::vector<OrbitRecord> records_from_rest(const std::vector<double> &omegas,
                                                  const std::function<Scene(double)> &scene_at,
                                                  const RecordOptions &options,
                                                  const std::function<void()> &advance) {
  std::vector<OrbitRecord> records;
  sweep(
      omegas.size(), [&](std::size_t i) { return record_of(scene_at(omegas[i]), options); },
      [&](std::size_t, const OrbitRecord &record) {
        records.push_back(record);
        advance();
      });
  return records;
}

// The distinct impact velocities of a mass (from 1), the column v<mass>, at every frequency.
inline Table impact_velocities(const std::vector<double> &omegas,
                               const std::vector<OrbitRecord> &records, int mass) {
  Table table("omega,v" + std::to_string(mass));
  for (std::size_t i = 0; i < omegas.size(); ++i)
    for (const double v :
         distinct(records[i].impact_velocities[static_cast<std::size_t>(mass - 1)]))
      table.row(omegas[i], v);
  return table;
}

}  // namespace vibro_impact::figures
