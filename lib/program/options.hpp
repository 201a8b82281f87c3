// The command line of `vibro-impact`, and the two commands that it asks for.
#pragma once

#include <array>
#include <string>
#include <variant>
#include <vector>

#include "files.hpp"
#include "processes.hpp"
#include "vibro_impact/analysis/sweep.hpp"
#include "vibro_impact/simulate.hpp"

namespace vibro_impact::runner {

// Both commands have the file of the scene, which no output may replace, the head of the tables
// (lines of comments, or nothing), and the masses that have a panel in pictures.
struct Common {
  std::string scene_file, head;
  std::vector<int> panels;
};

// One run. All times are non-dimensional.
struct RunRequest : Common {
  Scene scene;
  RunOptions options;
  double until = 0.0, from = 0.0, every = 0.0;
  bool velocities = false;  // beside the displacements of the samples
  Output events{"--events"}, samples{"--samples"}, summary{"--summary"}, plot{"--plot"},
      portrait{"--portrait"};
};

// A sweep. `definition` has the options on which the rows of its tables depend, in lines of
// comments.
struct SweepRequest : Common {
  std::string definition;
  Grid grid;
  RecordOptions records;
  std::array<Output, 3> tables{{{"--table"}, {"--impacts"}, {"--section"}}};
  Output plot{"--plot"};
  std::string column = "period";  // of the table, drawn in a map
  bool resume = false;
  bool follow = false;  // each point from the settled state of the one before, ...
  bool back = false;    // ... along the innermost range and back again
};

// The request of a command line: a run, a sweep, or a text for standard output.
using Request = std::variant<RunRequest, SweepRequest, std::string>;

// Reads the command line, and the file of --scene. Throws std::invalid_argument with one line for a
// command line that makes no sense, and for a scene or a grid that `check` refuses.
Request parse(int argc, const char *const *argv);

// The text of --help below the options: examples, formats of the tables and exit status.
std::string footer();

// Runs the scene and writes its files. Throws std::invalid_argument for a file that cannot be
// written, before the run, and std::runtime_error when the run is given up or writing fails.
void run_scene(const RunRequest &request);

// Computes the tables of a sweep. To be called by all processes; that of rank 0 writes the files.
// Throws as `run_scene` does, and std::invalid_argument for rows of another sweep or program.
void run_sweep(const SweepRequest &request, const Processes &processes);

}  // namespace vibro_impact::runner
