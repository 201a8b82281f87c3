// The options of `vibro-impact sweep`.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scene_options.hpp"
#include "vibro_impact/analysis/sweep.hpp"

namespace vibro_impact::runner {

// A sweep as the user asked for it.
struct SweepRequest {
  Grid grid;
  RecordOptions records;
  int threads = 0;          // 0: all
  std::string table = "-";  // `-`: standard output
  bool resume = false, progress = false;
};

struct SweepWords {
  SceneWords scene;
  std::vector<std::string> vary;
  std::string table = "-", threads, longest = "400", counted = "40", most_periods = "8",
              tolerance = "1e-10", most_impacts = "1000000";
  bool resume = false, progress = false, no_lyapunov = false, pairs = false;
};

struct SweepGiven {
  SceneOptions scene;
  const CLI::Option *vary = nullptr, *threads = nullptr;
};

constexpr const char *sweep_purpose = "Record the settled motion at many parameter points";

SweepGiven add_sweep_options(CLI::App &app, SweepWords &words);

// Throws BadInput, or std::invalid_argument from `check` for a grid that makes no sense.
SweepRequest sweep_of(const CLI::App &app, const SweepWords &words, const SweepGiven &given);

}  // namespace vibro_impact::runner
