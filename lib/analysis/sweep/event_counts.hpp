// The events of whole forcing periods, as motions are compared by them.
#pragma once

#include <vector>

#include "vibro_impact/event.hpp"
#include "vibro_impact/scene.hpp"

namespace vibro_impact {

// True of two events of one kind at one stop.
inline bool same_kind(const Event &a, const Event &b) {
  return a.kind == b.kind && a.stop == b.stop;
}

// The events of whole periods without the impacts of complete chatters, or without all impacts
// between a stick and the event before it at the stop.
std::vector<Event> without_chatters(const Scene &scene, const std::vector<Event> &events,
                                    bool all_before_sticks = false);

}  // namespace vibro_impact
