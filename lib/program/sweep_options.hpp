// The options of `vibro-impact sweep`.
#pragma once

#include <string>
#include <vector>

#include "scene_options.hpp"
#include "vibro_impact/analysis/sweep.hpp"

namespace vibro_impact::runner {

// A sweep as the user asked for it.
struct SweepRequest {
  Grid grid = {};
  RecordOptions records = {};
  int threads = 0;          // 0: all
  std::string table = "-";  // `-`: standard output
  bool resume = false, progress = false;
  std::string definition = {};  // everything that the table depends on, in one line
};

// The options and what they have taken so far.
struct SweepOptionsOf {
  SweepRequest request = {};
  SceneOptions scene = {};
  std::vector<std::string> vary = {};
};

void add_sweep_options(CLI::App &app, SweepOptionsOf &options);

// Throws std::invalid_argument with one line, that of `check` for a grid that makes no sense.
SweepRequest sweep_of(const CLI::App &app, SweepOptionsOf options);

}  // namespace vibro_impact::runner
