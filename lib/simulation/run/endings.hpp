// The endings of a call: its end or a recorder that is done, and the reasons to give the run up.
#pragma once

#include "run.hpp"

namespace vibro_impact::detail {

// Ends the call of `advance`. The first ending and reason of a call are kept.
void stop_run(Run &run, Ending ending, std::string reason = {});

// Gives the run up when a motion of it, just after its events or at the end of the call, has left
// the range of double precision, or lies beyond a stop by more than rounding: an event was missed.
void check_motion(Run &run, const Motion &motion);

// Gives the run up when a flight ends at an event without a time: the search for it has failed.
void check_search(Run &run, const FlightEnd &end);

// The steps that are left of those of the call.
long long steps_left(const Run &run);

// Gives the run up when the call has taken its steps.
void check_steps(Run &run);

}  // namespace vibro_impact::detail
