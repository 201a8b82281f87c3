// The events at one instant: the impacts, the decision which masses stick or are released, and the
// chatter to which the impacts belong.
#pragma once

#include "run.hpp"

namespace vibro_impact::detail {

// Lets time pass at the stops.
void forget_instant(Run &run);

// Handles the events at the end of a flight, to which the run has been moved, or at the start of
// the run. scratch.near tells which contacts have come to zero.
void handle_instant(Run &run, Recorders recorders);

// Handles the events at the start of a run. Masses at their stop that move into it have an impact,
// and all masses at rest at a stop stick or are released.
void handle_start(Run &run, Recorders recorders);

// Puts the run at the limit of its chatter: the masses hit come to rest there.
void enter_limit(Run &run, Recorders recorders);

}  // namespace vibro_impact::detail
