// The command line of `vibro-impact`, and the two commands that it asks for.
#pragma once

#include <string>
#include <variant>

#include "processes.hpp"
#include "vibro_impact/analysis/sweep.hpp"
#include "vibro_impact/simulate.hpp"

namespace vibro_impact::runner {

// One run. An empty path means that the file is not wanted; `-` is standard output.
struct RunRequest {
  Scene scene;
  RunOptions options;
  double until = 750.0, from = 0.0, every = 0.01;  // non-dimensional times
  std::string events, samples, plot;
};

// A sweep. `definition` has in one line the options on which the rows of its table depend.
struct SweepRequest {
  Grid grid;
  RecordOptions records;
  std::string table;
  bool resume = false;
  std::string definition;
};

// The request of a command line: a run, a sweep, or the text of --help or --version.
using Request = std::variant<RunRequest, SweepRequest, std::string>;

// Reads the command line, and no file. The help offers processes of MPI if `with_mpi`. Throws
// std::invalid_argument with one line for a command line that makes no sense, and for a scene or a
// grid that `check` refuses.
Request parse(int argc, const char *const *argv, bool with_mpi = false);

// Runs the scene and writes its files. Throws std::invalid_argument for a file that cannot be
// written, before the run, and std::runtime_error when the run is given up or writing fails.
void run_scene(const RunRequest &request);

// Computes the table of a sweep. To be called by all processes; that of rank 0 writes the files.
// Throws as `run_scene` does, and std::invalid_argument for rows of another sweep or program.
void run_sweep(const SweepRequest &request, const Processes &processes);

}  // namespace vibro_impact::runner
