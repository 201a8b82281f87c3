// The kinds of events.
#pragma once

namespace vibro_impact {

enum class EventKind { impact, stick, release };

// "impact", "stick" or "release".
const char *name(EventKind kind);

}  // namespace vibro_impact
