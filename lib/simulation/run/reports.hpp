// The reports of a run to its recorders: its events, the samples between them, and the end of a
// call. They change nothing of the run but its progress, the sums of what was reported, and
// scratch.
#pragma once

#include "run.hpp"

namespace vibro_impact::detail {

// Reports an event at a stop, and ends the call when a recorder is done. `before` and `after` are
// the velocities of an impact, else 0.
void report_event(Run &run, EventKind kind, std::size_t stop, double before, double after,
                  bool by_a_jump, const ImpactSum &taken, Recorders recorders);

// Reports an impact. Before the limit of a chatter that is ahead, it adds one that is too slow to
// those that are unreported.
void report_impact(Run &run, std::size_t stop, double closing, double leaving, Recorders recorders);

// The next time at which a recorder asks for a sample; infinite when there is none.
double next_sample(Recorders recorders);

// Reports the samples on the step or long flight of the run, up to its end at `tau` after the
// motion of the run. Their times are compared with that of the end as it is reported: a sample at
// the rounded time of an event has the motion before it.
void sample(Run &run, const Real &tau, Recorders recorders);

// Ends the call at its end, on the step or long flight of the run.
void end_at_time(Run &run, Recorders recorders);

// The state in which the run stands.
MotionState state_of(const Run &run);

}  // namespace vibro_impact::detail
