// What a user asks of `vibro-impact` on its command line, and the two commands that do it.
#pragma once

#include <optional>
#include <string>

#include "interrupt.hpp"
#include "processes.hpp"
#include "vibro_impact/analysis/sweep.hpp"
#include "vibro_impact/simulate.hpp"

namespace vibro_impact::runner {

struct SweepRequest {
  Grid grid = {};
  RecordOptions records = {};
  std::string table;
  bool resume = false;
  std::string definition = {};  // everything that the table depends on, in one line
};

// One run, or a sweep, as the user asked for it; an empty path means that the file is not wanted.
struct Request {
  Scene scene;             // empty with `resume`: the scene stands in that file
  std::string scene_text;  // the options that gave it
  RunOptions options;
  double until = 750.0, from = 0.0, every = 0.01;
  std::string events, samples, save_state, resume, plot;
  std::optional<SweepRequest> sweep = {};  // instead of a run
};

// Reads the command line into `request`, and no file; returns the text that --help and --version
// ask for instead of a run.
// Throws std::invalid_argument with one line, that of `check` for a scene or a grid that makes no
// sense.
std::optional<std::string> parse(int argc, char **argv, Request &request);

// Both throw std::invalid_argument, std::runtime_error and EndedBySignal with one line.

// Runs the scene and writes its files. Ends early, with EndedBySignal, when `signal`, asked at
// every flight and sample, gives the number of one.
void run_scene(const Request &request, int (*signal)() = signal_that_came);

// Computes the table of a sweep. On ranks above 0, lends a hand and touches no file.
void run_sweep(const SweepRequest &request, const Processes &processes);

}  // namespace vibro_impact::runner
