// The chatter of a run: its impacts are followed, and at a node of the extrapolation the run is
// carried to the limit. If an end, a sample or a listed impact lies before the limit, the run goes
// on from impact to impact up to there, and is then put to the limit that was found at the node.
#pragma once

#include "run.hpp"

namespace vibro_impact::detail {

// Adds the impact of this instant to its chatter, and sets the step hint to the longest flight
// expected after the impacts. The chatter ends at an instant with none or several impacts, with a
// mass left at rest, with another contact mode than the one before, where nothing presses the mass,
// and with r = 1.
void follow_chatter(Run &run, const ContactMode *mode_before);

// Puts the run to the limit that has been found: the mass comes to rest.
void enter_limit(Run &run, Recorders recorders);

// After the events of an instant, and as a call begins: finds the limit if the run stands just
// after an impact that is a node of the extrapolation. Puts the run there as soon as no end, sample
// or impact that is asked for lies before it.
void take_limit(Run &run, Recorders recorders);

// If a limit ahead lies in this call and within the time tau, reports the samples before it, and
// puts the run there unless a recorder is done. Returns false if it does not.
bool limit_ends_flight(Run &run, const Real &tau, Recorders recorders);

// Drops the work since the node of a limit ahead, but for states and modes: beyond the limit, a run
// with samples is given up where it is without. Up to the limit the work has its own `max_steps`.
void count_as_at_node(Run &run);

}  // namespace vibro_impact::detail
