// The events of whole forcing periods, as motions are compared by them.
#pragma once

#include <vector>

#include "vibro_impact/event.hpp"
#include "vibro_impact/scene.hpp"

namespace vibro_impact {

// The events of whole periods without the impacts of complete chatters, or without all impacts
// between a stick and the event before it at the stop.
std::vector<Event> without_chatters(const Scene &scene, const std::vector<Event> &events,
                                    bool all_before_sticks = false);

// True if these events of whole periods are the same, in kind and stop, from any of them on.
bool same_events(const std::vector<Event> &a, const std::vector<Event> &b);

}  // namespace vibro_impact
