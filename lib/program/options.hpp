// The command line of `vibro-impact`, and the commands that it asks for.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "files.hpp"
#include "vibro_impact/analysis/sweep.hpp"
#include "vibro_impact/simulate.hpp"

namespace vibro_impact::runner {

// All commands have the file of the scene, which no output may replace, the head of the tables
// (lines of comments, or nothing), and the masses that have a panel in pictures.
struct Common {
  std::string scene_file, head;
  std::vector<int> panels;
};

// One run, from the initial state of the scene or another start. All times are non-dimensional.
struct RunRequest : Common {
  Scene scene;
  std::optional<MotionState> start;
  RunOptions options;
  double until = 0.0, from = 0.0, every = 0.0;
  std::optional<double> slowest;  // impact of a chatter in the tables
  bool velocities = false;        // beside the displacements of the samples
  Output events{"--events"}, samples{"--samples"}, summary{"--summary"}, plot{"--plot"},
      portrait{"--portrait"};
};

// The search for a periodic orbit, near the motion that has settled or near the start. The outputs
// of the run are those of one period of the orbit.
struct OrbitRequest : RunRequest {
  int period = 0;  // forcing periods; 0: that of the motion that has settled
  bool near_start = false;
  SettleOptions settle;
  std::optional<Axis> range;  // along which the orbit is followed, in both directions
  Output table{"--table"};
  // With a range, `plot` shows this column of the table, or the fastest impacts, over the impacts
  // of a sweep in a file.
  std::string column, diagram;
};

// A sweep, or one of its consecutive parts. The tables of the parts put together are those of the
// sweep: the first alone has the header.
struct SweepRequest : Common {
  Grid grid;
  RecordOptions records;
  std::array<Output, 3> tables{{{"--table"}, {"--impacts"}, {"--section"}}};
  Output plot{"--plot"};
  std::string column;   // of the table, drawn in the picture; empty: not given
  bool follow = false;  // each point from the settled state of the one before, ...
  bool back = false;    // ... along the innermost range and back again
  std::size_t part = 1, parts = 1;
};

// The request of a command line: that of a command, or a text for standard output.
using Request = std::variant<RunRequest, OrbitRequest, SweepRequest, std::string>;

// Reads the command line, and the file of --scene. Throws std::invalid_argument with one line for a
// command line that makes no sense, and for a scene or a grid that `check` refuses.
Request parse(int argc, const char *const *argv);

// The texts of --help below the options, of the program and of its commands.
std::string footer_of_program();
std::string footer_of_run();
std::string footer_of_orbit();
std::string footer_of_sweep();

// Runs the scene and writes its files. Throws std::invalid_argument for a file that cannot be
// written, before the run, and std::runtime_error when the run is given up or writing fails.
void run_scene(const RunRequest &request);

// Its parts: refuses outputs that cannot be written, which another output may be added to, and a
// picture whose table is not written; and runs, writes and draws.
void check_outputs_of(const RunRequest &request, const Output &more, const Output &table_of_plot);
Outcome record_run(const RunRequest &request);

// Finds the orbit, prints it and writes its files. Throws as `run_scene` does, and
// std::runtime_error if no orbit was found.
void run_orbit(const OrbitRequest &request);

// Computes the tables of a sweep and writes its files. Throws as `run_scene` does.
void run_sweep(const SweepRequest &request);

}  // namespace vibro_impact::runner
