// `vibro-impact run`.
#pragma once

#include "interrupt.hpp"
#include "options.hpp"

namespace vibro_impact::runner {

// Runs the scene and writes its files. Ends early, with EndedBySignal, when `signal`, asked at
// every flight, gives the number of one. Throws std::invalid_argument and std::runtime_error with
// one line.
void run_scene(const Request &request, int (*signal)() = signal_that_came);

}  // namespace vibro_impact::runner
