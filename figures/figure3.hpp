// The bifurcation diagrams of Figure 3: impact velocities against the forcing frequency, from rest
// as in the paper and followed upwards and downwards.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
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

// The tables of a diagram, rows in the order of the frequencies.
struct Diagram {
  std::array<Table, 2> velocities{Table("omega,v1"), Table("omega,v2")};
  // Per forcing period; period 0: none. The last column is empty where it was not asked for.
  Table orbits{"omega,period,impacts1,impacts2,chatters1,chatters2,lyapunov"};
};

inline void add(Diagram &diagram, double omega, const OrbitRecord &record) {
  for (std::size_t mass = 0; mass < 2; ++mass)
    for (const double v : distinct(record.impact_velocities[mass]))
      diagram.velocities[mass].row(omega, v);
  Table &orbits = diagram.orbits;
  orbits.cell(omega);
  orbits.cell(record.period);
  for (const auto *counts : {&record.counts.impacts, &record.counts.chatters})
    for (const int count : *counts) orbits.cell(count / static_cast<double>(record.counts.periods));
  if (record.lyapunov)
    orbits.cell(*record.lyapunov);
  else
    orbits.cell(std::string_view());
  orbits.end_row();
}

// From rest at every frequency. `advance` is called after each of them.
inline Diagram diagram_from_rest(const std::vector<double> &omegas, const RecordOptions &options,
                                 const std::function<void()> &advance) {
  Diagram diagram;
  sweep(
      omegas.size(), [&](std::size_t i) { return record_of(paper::figure3(omegas[i]), options); },
      [&](std::size_t i, const OrbitRecord &record) {
        add(diagram, omegas[i], record);
        advance();
      });
  return diagram;
}

// From where the motion stood at the frequency before; at the first one from rest.
inline Diagram diagram_followed(const std::vector<double> &omegas, const RecordOptions &options,
                                const std::function<void()> &advance) {
  Diagram diagram;
  MotionState state = start_of(paper::figure3(omegas.front()));
  for (const double omega : omegas) {
    OrbitRecord record = record_of(paper::figure3(omega), state, options);
    add(diagram, omega, record);
    state = std::move(record.state);
    advance();
  }
  return diagram;
}

}  // namespace vibro_impact::figures
