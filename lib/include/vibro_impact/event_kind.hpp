// The kinds of events: a mass hits its stop, comes to stick at its stop, or is released from it.
#pragma once

namespace vibro_impact {

enum class EventKind { impact, stick, release };

// Returns "impact", "stick" or "release".
const char *name(EventKind kind);

}  // namespace vibro_impact
