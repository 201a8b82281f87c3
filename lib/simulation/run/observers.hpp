// The reports of a run to its recorders. They change nothing of the run but its progress.
#pragma once

#include "run.hpp"

namespace vibro_impact::detail {

// The velocities of an impact, just before and just after it.
struct ImpactVelocities {
  double before = 0.0, after = 0.0;
};

// Reports an event at a stop, and ends the call when a recorder is done. Events inside a chatter,
// before the limit that the run takes, are not reported.
void report_event(Run &run, EventKind kind, std::size_t stop, ImpactVelocities velocities,
                  bool by_a_jump, Recorders recorders);

// The next time at which a recorder asks for a sample; infinite when there is none.
double next_sample(Recorders recorders);

// Reports the sample at `time`, at which scratch.sampled stands. Returns true when a recorder is
// done.
bool report_sample(Run &run, double time, Recorders recorders);

}  // namespace vibro_impact::detail
