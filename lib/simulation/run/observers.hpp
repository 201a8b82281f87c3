// The reports of a run to its recorders. The functions of this header do not change the run.
#pragma once

#include "run.hpp"

namespace vibro_impact::detail {

// The velocities of an impact, just before and just after it.
struct ImpactVelocities {
  double before = 0.0, after = 0.0;
};

// Reports an event at a stop; `event` is scratch. Returns true when a recorder is done.
bool report(const Run &run, EventKind kind, std::size_t stop, ImpactVelocities velocities,
            bool by_a_jump, Recorders recorders, Event &event);

// The next time at which a recorder asks for a sample; infinite when there is none.
double next_sample(Recorders recorders);

// Reports the sample at `time`, at which `motion` stands. Returns true when a recorder is done.
bool report_sample(const Motion &motion, double time, const Clock &clock, Recorders recorders);

}  // namespace vibro_impact::detail
