// The impacts at one instant.
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

}  // namespace vibro_impact::detail
