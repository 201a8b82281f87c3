// The options of the command line, as CLI11 reads them, and the words of those whose values depend
// on the scene.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "options.hpp"

namespace vibro_impact::runner {

// The group of the options that are fields of a scene.
inline constexpr const char *scene_group = "Scene";

struct Words {
  std::string scene_file, until = "750", from = "0", every = "0.01", every_in_orbit = "0.002P",
                          panels, part = "1/1";
  std::vector<std::string> ranges;
  bool print_scene = false, header = false;
};

// The bound of the steps of a run, for two masses that of the library, and of a point of a sweep. A
// step takes 2 microseconds with two masses and 22 with a hundred.
long long default_steps(bool of_run, int masses);

// These give the commands their options, with the defaults of the requests.
void add_run_options(CLI::App &run, RunRequest &request, Words &words);
void add_orbit_options(CLI::App &orbit, OrbitRequest &request, Words &words);
void add_sweep_options(CLI::App &sweep, SweepRequest &request, Words &words);

}  // namespace vibro_impact::runner
