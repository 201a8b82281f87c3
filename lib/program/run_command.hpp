// `vibro-impact run`.
#pragma once

#include "interrupt.hpp"
#include "options.hpp"

namespace vibro_impact::runner {

// Runs the scene and writes its files. Ends early when `signal`, asked at every flight, gives the
// number of one. Returns the exit status: 0, or 128 + that number. Throws BadInput,
// std::invalid_argument and std::runtime_error with one line.
int run_scene(const Request &request, int (*signal)() = signal_that_came);

}  // namespace vibro_impact::runner
