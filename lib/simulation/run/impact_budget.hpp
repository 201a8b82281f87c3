// The bound of the impacts of a run. A run without chatters slower than r = 0.999 does without most
// of it.
#pragma once

#include "run.hpp"

namespace vibro_impact::detail {

// Counts an impact at a stop, at this closing speed, among those of its chatter. Gives the run up
// when there are too many impacts in a window of time. `hits` are all contacts of this instant.
void count_impact(Run &run, std::span<const std::size_t> hits, StopState &stop, double speed);

}  // namespace vibro_impact::detail
