// Who is held of the masses that rest on their stops where the hold force is zero: by trial.
//
// The force on such a mass says nothing at that instant. What it becomes depends on which of its
// neighbours move, and that on the forces on them. So every assignment of held and free to the
// masses in question is tried: its closed form is followed for a short time, and it stands if every
// held mass is pressed into its stop and every free one is off it all that time. Such a motion
// obeys every rule of the model for that time, and the model has one motion only; exactly one
// assignment may stand.
#pragma once

#include "signals.hpp"

#include <cstddef>
#include <vector>

namespace vibro_impact_reference {

/// Decides who of the masses at the stops `in_question`, all at rest there, is held, and writes it
/// into the state: stuck_on, stop_start, and how long that stands. Throws std::runtime_error if no
/// assignment stands for any of the times tried, or more than one.
void decide_at_rest(const Scene &scene, State &state, const std::vector<std::size_t> &in_question,
                    Eigensystems &known);

}  // namespace vibro_impact_reference
