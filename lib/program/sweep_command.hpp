// `vibro-impact sweep`.
#pragma once

#include "processes.hpp"
#include "sweep_options.hpp"

namespace vibro_impact::runner {

// Computes the table of a sweep. On ranks above 0, lends a hand and touches no file. Throws
// std::invalid_argument, std::runtime_error and EndedBySignal with one line; on ranks above 0
// nothing that rank 0 does not say.
void run_sweep(const SweepRequest &request, const Processes &processes);

}  // namespace vibro_impact::runner
