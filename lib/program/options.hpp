// The command line of `vibro-impact`.
#pragma once

#include <optional>
#include <string>

#include "sweep_options.hpp"
#include "vibro_impact/simulate.hpp"

namespace vibro_impact::runner {

// One run, or a sweep, as the user asked for it; an empty path means that the file is not wanted.
struct Request {
  Scene scene;             // empty with `resume`: the scene stands in that file
  std::string scene_text;  // the options that gave it
  RunOptions options;
  double until = 750.0, from = 0.0, every = 0.01;
  std::string events, samples, save_state, resume, plot;
  bool progress = false;                   // also where standard error is no terminal
  std::optional<SweepRequest> sweep = {};  // instead of a run
};

// Text asked for with --help or --version, to be printed instead of a run.
struct Answer {
  std::string text;
};

// Reads the command line into `request`, and no file; returns the answer to --help and --version.
// Throws BadInput, or std::invalid_argument from `check` for a scene that makes no sense.
std::optional<Answer> parse(int argc, char **argv, Request &request);

}  // namespace vibro_impact::runner
