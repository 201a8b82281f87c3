// A map of settled motions from rest over a grid of parameters, as the atlas and the long chain
// show.
#pragma once

#include "program/progress.hpp"
#include "vibro_impact/analysis/analysis.hpp"

namespace vibro_impact::figures {

// One row per point (sweep_table). `progress` advances by one with each.
inline Table map_of(const Grid &grid, const RecordOptions &options, Progress &progress) {
  Table map = sweep_table(grid, options);
  sweep(
      grid.points(), [&](std::size_t point) { return record_of(grid.scene_at(point), options); },
      [&](std::size_t point, const OrbitRecord &record) {
        add_row(map, grid, options, point, record);
        progress.advance();
      });
  return map;
}

}  // namespace vibro_impact::figures
