// The samples between the events of a run, and the end of a call at its time. Neither moves the
// run.
#pragma once

#include "run.hpp"

namespace vibro_impact::detail {

// The time from the motion of the run to an instant.
Real time_until(const Run &run, const Instant &instant);

// Reports the samples on the step or long flight of the run, up to its end at `tau` after the
// motion of the run. Their times are compared with that of the end as it is reported: a sample at
// the rounded time of an event has the motion before it.
void sample(Run &run, const Real &tau, Recorders recorders);

// Ends the call at its end, on the step or long flight of the run.
void end_at_time(Run &run, Recorders recorders);

}  // namespace vibro_impact::detail
