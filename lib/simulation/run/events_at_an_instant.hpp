// The events at one instant: the impacts, the decision which masses stick or are released, and the
// chatter to which the impacts belong.
#pragma once

#include "run.hpp"

namespace vibro_impact::detail {

// Contacts of the mode with an impact, or with a root of the hold force, at one instant.
struct ContactsOfInstant {
  std::span<const std::size_t> hits = {}, roots = {};
};

// Ends the call of `advance`. The first ending and reason of a call are kept.
void stop_run(Run &run, Ending ending, std::string reason = {});

// Handles the events at the end of a step. The run has been moved there.
void handle_instant(Run &run, Recorders recorders);

// Handles the events at the start of a run. Masses at their stop that move into it have an impact,
// and all masses at rest at a stop stick or are released.
void handle_start(Run &run, Recorders recorders);

// Decides which masses stick after this instant, for all masses in question together, and enters
// the contact mode that follows. At the start of a run scratch.state is the exact initial state.
void hold_or_release(Run &run, const ContactsOfInstant &contacts, Recorders recorders,
                     bool at_start = false);

}  // namespace vibro_impact::detail
