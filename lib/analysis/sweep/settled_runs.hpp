// The function of settle.hpp, of a scene that has been checked.
#pragma once

#include "vibro_impact/analysis/settle.hpp"

namespace vibro_impact {

EventCounts counts_in(const Scene &scene, const std::vector<Event> &events, int periods,
                      const Held &held);

}  // namespace vibro_impact
