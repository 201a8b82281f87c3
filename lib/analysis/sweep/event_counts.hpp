// Events of whole periods of a motion that repeats after them, so that a chatter under way at the
// end goes on at the beginning.
#pragma once

#include "vibro_impact/analysis/settle.hpp"

namespace vibro_impact {

// The events without the impacts of complete chatters.
std::vector<Event> without_chatters(const Scene &scene, const std::vector<Event> &events);

// The counts of these events; `held` is the contact mode at the start.
EventCounts counts_of(const Scene &scene, const std::vector<Event> &events, int periods,
                      const Held &held);

}  // namespace vibro_impact
