// What happens at one instant: impacts, which masses are held after it, and the chatter that the
// impacts belong to.
#pragma once

#include "run.hpp"

namespace vibro_impact::detail {

// Ends the call of `advance`, unless it has ended before.
void stop_run(Run &run, Ending ending, std::string reason = {});

// Handles the events at the end of the flight, to which the run has been moved.
void handle_instant(Run &run, Recorders recorders);

// Handles the events of the start: masses that move into their stop have their impact at this
// instant, and belong to it with those at rest on one. Nothing is known of the stops but the gaps.
void handle_start(Run &run, Recorders recorders);

// Decides who is held after the instant, for all masses in question at once, and enters the contact
// mode that follows. At the start of a run its motion is known exactly, and stands there already.
void hold_or_release(Run &run, Recorders recorders, bool at_start = false);

}  // namespace vibro_impact::detail
