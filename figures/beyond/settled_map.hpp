// The settled motions at the points of a grid of parameters, as the atlas and the basins show them.
#pragma once

#include <string>
#include <vector>

#include "vibro_impact/analysis/analysis.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace vibro_impact::figures {

// Period (forcing periods, 0: none up to 8), and sticking phases and impacts of every mass per
// forcing period; impacts of a complete chatter are not counted.
struct SettledPoint {
  int period = 0;
  std::vector<double> sticks, impacts;

  bool mass_sticks(int mass) const {
    return sticks[static_cast<std::size_t>(mass - 1)] > 0.0;
  }
};

// The motion from the initial state of a scene, followed for at most `longest` forcing periods.
inline SettledPoint settled_point(const Scene &scene, int longest) {
  RecordOptions options;
  options.settle.longest = longest;
  const OrbitRecord record = record_of(scene, options);
  SettledPoint point{record.period, {}, {}};
  const auto rate = [&](int count) { return count / static_cast<double>(record.counts.periods); };
  for (const int count : record.counts.sticks) point.sticks.push_back(rate(count));
  for (const int count : record.counts.impacts) point.impacts.push_back(rate(count));
  return point;
}

inline std::vector<SettledPoint> settled_points(const Grid &grid, int longest) {
  return sweep(grid, [longest](const Scene &scene) { return settled_point(scene, longest); });
}

// The columns are those of `vibro-impact sweep`: the parameters, period, sticks1 .., impacts1 ...
inline Table table_of(const Grid &grid, const std::vector<SettledPoint> &points) {
  std::string header;
  for (const Axis &axis : grid.axes) header += name(axis.parameter) + ",";
  header += "period";
  for (const char *count : {"sticks", "impacts"})
    for (int mass = 1; mass <= grid.scene.masses(); ++mass)
      header += "," + (count + std::to_string(mass));
  Table table(header);
  for (std::size_t k = 0; k < points.size(); ++k) {
    for (const double value : grid.values(k)) table.cell(value);
    table.cell(points[k].period);
    for (const auto *rates : {&points[k].sticks, &points[k].impacts})
      for (const double rate : *rates) table.cell(rate);
    table.end_row();
  }
  return table;
}

}  // namespace vibro_impact::figures
