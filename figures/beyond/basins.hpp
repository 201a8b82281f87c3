// Basins of attraction: which motion an initial displacement settles on, where more than one is
// there to settle on.
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

// A motion that others settle on.
struct Attractor {
  OrbitRecord record;
  std::vector<std::vector<double>> sections;  // its states at the phase of the start, one a period
  std::vector<std::size_t> points = {};       // of the grid that settle on it
};

struct Basins {
  std::vector<Attractor> attractors;  // the one of most points first
  std::vector<int> of;                // per point of the grid, a number from 1; 0: not settled
};

// A section that is the attractor's, to 1e-8: settled states agree to 1e-10; the two
// attractors beside the border orbit are 1e-7 apart.
inline bool is_on(const Attractor &attractor, int period, const std::vector<double> &state) {
  if (period != attractor.record.period) return false;
  return std::any_of(attractor.sections.begin(), attractor.sections.end(), [&](const auto &at) {
    double apart = 0.0;
    for (std::size_t i = 0; i < at.size(); ++i) apart = std::max(apart, std::abs(at[i] - state[i]));
    return apart < 1e-8;
  });
}

inline Attractor attractor_of(const Scene &scene, const OrbitRecord &record) {
  Attractor attractor{record, {coordinates(record.state)}};
  for (int k = 1; k < record.period; ++k)
    attractor.sections.push_back(coordinates(stroboscopic_map(scene, record.state, k).state));
  return attractor;
}

// The attractors met from the points of the grid, each from its scene's initial state; `advance` is
// called after each of them.
inline Basins basins_of(
    const Grid &grid, const RecordOptions &options, const std::function<void()> &advance = [] {}) {
  check(grid);
  Basins basins{{}, std::vector<int>(grid.points(), 0)};
  auto &all = basins.attractors;
  sweep(
      grid.points(), [&](std::size_t point) { return record_of(grid.scene_at(point), options); },
      [&](std::size_t point, const OrbitRecord &record) {
        advance();
        if (record.period == 0) return;
        const std::vector<double> state = coordinates(record.state);
        auto found = std::find_if(all.begin(), all.end(), [&](const Attractor &attractor) {
          return is_on(attractor, record.period, state);
        });
        if (found == all.end()) found = all.insert(all.end(), attractor_of(grid.scene, record));
        found->points.push_back(point);
      });
  std::stable_sort(all.begin(), all.end(), [](const Attractor &a, const Attractor &b) {
    return a.points.size() > b.points.size();
  });
  for (std::size_t k = 0; k < all.size(); ++k)
    for (const std::size_t point : all[k].points) basins.of[point] = static_cast<int>(k) + 1;
  return basins;
}

// A scene with more than one attractor, and the plane of initial displacements, at rest, shown.
struct BasinPlane {
  std::string name;
  Grid grid;
};

// `count` x `count` displacements, each mass from its stop to 1.4 away from it.
inline Grid displacements(const Scene &scene, int count) {
  const auto axis = [&](const Stop &stop) {
    const double away = stop.side == Side::lower ? 1.4 : -1.4;
    return Axis{{Parameter::Kind::displacement, stop.mass},
                std::min(stop.position, stop.position + away),
                std::max(stop.position, stop.position + away),
                static_cast<std::size_t>(count)};
  };
  return {scene, {axis(scene.stops[0]), axis(scene.stops[1])}};
}

// Where attractors live side by side: over a wide range of frequencies; many of them; beyond the
// grazing of Figure 5(b), and beside a border orbit (bifurcations.csv), in narrow ones.
inline std::vector<BasinPlane> basin_planes(int count) {
  Scene grazing = paper::figure5b();
  grazing.omega = 0.299518;
  return {{"wide", displacements(paper::figure3(0.77), count)},
          {"many", displacements(paper::figure3(0.625), count)},
          {"grazing", displacements(grazing, count)},
          {"border", displacements(paper::figure3(0.36782295), count)}};
}

inline RecordOptions recorded_in_basins() {
  RecordOptions options;
  options.settle.longest = 1000;     // close to bifurcations motions settle slowly,
  options.settle.tolerance = 1e-11;  // and attractors are close to each other
  return options;
}

}  // namespace vibro_impact::figures
