// The samples between the events of a run, and the end of a call at its time. Neither moves the
// run.
#pragma once

#include "run.hpp"

namespace vibro_impact::detail {

// The time from the motion of the run to an instant.
Real time_until(const Run &run, const Instant &instant);

// Reports the samples up to `tau` after the motion of the run, on its step or long flight.
void sample(Run &run, const Real &tau, Recorders recorders);

// Ends the call at its end, on the step or long flight of the run.
void end_at_time(Run &run, Recorders recorders);

// Advances a copy of the run through the impacts before the limit of its chatter, up to an end
// there, or else as far as there are samples, or impacts at `slowest` and faster. A run that ends
// there takes over the end state of the copy, and stays itself at the latest node: the next call
// finds the same limit again. The copy counts its own steps: a run with samples is given up where
// it is without.
void look_inside(Run &run, const Instant &limit, double slowest, Recorders recorders);

// Ends a call inside a chatter when no sample or impact is left to be reported.
void end_if_all_is_reported(Run &run);

// Gives the run up: the motion leaves the range of double precision before this instant.
void give_up_beyond_range(Run &run, const Instant &instant);

// Gives the run up: a mass (from 0) lies beyond its stop at this instant.
void give_up_beyond_stop(Run &run, std::size_t mass, const Instant &instant);

}  // namespace vibro_impact::detail
