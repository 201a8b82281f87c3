// The reports of a run to its recorders. They change nothing of the run but its progress.
#pragma once

#include "run.hpp"

namespace vibro_impact::detail {

// Ends the call of `advance`. The first ending and reason of a call are kept.
void stop_run(Run &run, Ending ending, std::string reason = {});

// Reports an event at a stop, and ends the call when a recorder is done. `before` and `after` are
// the velocities of an impact, else 0. Events inside a chatter, before the limit that the run
// takes, are not reported.
void report_event(Run &run, EventKind kind, std::size_t stop, double before, double after,
                  bool by_a_jump, Recorders recorders);

// The next time at which a recorder asks for a sample; infinite when there is none.
double next_sample(Recorders recorders);

// The motion at a time `tau` of the step, whose table is in scratch.flight, or of the long flight
// of the run. The rounding of a sample may put `tau` below 0, which is the start. The reference is
// valid until the next call.
const Motion &motion_at(Run &run, Real tau);

// Reports this motion as the sample at this time to the recorders that have asked for it. Returns
// true when one of them is done.
bool report_sample(Run &run, const Motion &motion, const Instant &at, double time,
                   Recorders recorders);

// The state of a motion of the run at an instant.
MotionState state_of(const Run &run, const Motion &motion, const Instant &at);

}  // namespace vibro_impact::detail
