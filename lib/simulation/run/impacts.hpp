// The impacts at one instant, and the chatter which they continue or begin.
#pragma once

#include "run.hpp"

namespace vibro_impact::detail {

// Finds the contacts that have come to zero, into scratch.hits those with an impact. A mass that
// comes to its stop without speed is at rest there.
void gather_hits(Run &run);

// Applies the impacts (Eqs. 8-11), then reports them. Simultaneous impacts act on different masses.
// A mass comes to rest when no speed is left, or when the time left to the limit of its chatter
// lies below rounding.
void apply_hits(Run &run, Recorders recorders);

// Adds the impacts to their chatter, and sets the step hint to the longest flight expected after
// them. The chatter ends at an instant without impacts, with a mass left at rest, or with another
// contact mode than the one before.
void follow_chatter(Run &run, const ContactMode *mode_before);

}  // namespace vibro_impact::detail
