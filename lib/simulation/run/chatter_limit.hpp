// The chatter of a run: its impacts are followed, and at a node of the extrapolation the run is
// carried to the limit. From one call to the next:
//
//   latest node      the motion of the run stands here, until it is carried to the limit
//   impacts          resolved by a copy of the run, if an end, a sample or a listed impact lies
//   here;
//                    `past_impacts`, `reported` and `unreported` tell what the copies have reported
//   limit            its event takes what no impact has reported
#pragma once

#include "run.hpp"

namespace vibro_impact::detail {

// Adds the impacts of this instant to their chatter, and sets the step hint to the longest flight
// expected after them. The chatter ends at an instant without impacts, with a mass left at rest,
// with another contact mode than the one before, where the stops differ in r, where nothing presses
// them, and with r = 1.
void follow_chatter(Run &run, const ContactMode *mode_before);

// Puts the run, whose motion is that at the limit of its chatter, there: the masses hit come to
// rest.
void enter_limit(Run &run, Recorders recorders);

// Moves the run to the limit of a chatter, if it stands just after an impact that is a node of the
// extrapolation, and the limit is found. An end, samples and impacts that are asked for before the
// limit are taken from a copy of the run.
void take_limit(Run &run, Recorders recorders);

// Notes, in a call inside a chatter, whether the impacts of this instant are fast enough to be
// listed. If not, the call may end: later impacts are slower.
void note_listed_impacts(Run &run);

// Ends a call inside a chatter when no sample or impact is left to be reported.
void end_if_all_is_reported(Run &run);

}  // namespace vibro_impact::detail
