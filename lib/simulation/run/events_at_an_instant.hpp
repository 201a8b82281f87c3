// The events at one instant: the impacts, and the decision which masses stick or are released.
#pragma once

#include "run.hpp"

namespace vibro_impact::detail {

// Lets time pass at the stops.
void forget_instant(Run &run);

// Handles the events at the end of a flight, to which the run has been moved, or at the start of
// the run. scratch.near tells which contacts have come to zero.
void handle_instant(Run &run, Recorders recorders);

// Decides which masses stick after this instant, for all masses in question together, and enters
// the contact mode that follows.
void hold_or_release(Run &run, Recorders recorders);

// Puts the run at its start, where any contact may be zero. In its events, masses at their stop
// that move into it have an impact, and all masses at rest at a stop stick or are released.
void put_at_start(Run &run);

}  // namespace vibro_impact::detail
