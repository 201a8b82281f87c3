// `vibro-impact run` and `vibro-impact sweep`.
#pragma once

#include "interrupt.hpp"
#include "options.hpp"
#include "processes.hpp"

namespace vibro_impact::runner {

// Both throw std::invalid_argument, std::runtime_error and EndedBySignal with one line.

// Runs the scene and writes its files. Ends early, with EndedBySignal, when `signal`, asked at
// every flight and sample, gives the number of one.
void run_scene(const Request &request, int (*signal)() = signal_that_came);

// Computes the table of a sweep. On ranks above 0, lends a hand and touches no file.
void run_sweep(const SweepRequest &request, const Processes &processes);

}  // namespace vibro_impact::runner
