// Times inside the chatters of a run, and sums over its events.
#pragma once

#include <algorithm>
#include <vector>

#include "events.hpp"
#include "random_scenes.hpp"

namespace vibro_impact::testing {

inline ImpactSum sum_of(const std::vector<Event> &events) {
  ImpactSum sum;
  for (const Event &event : events) sum += event.taken;
  return sum;
}

// A time in a run up to `until`: any, or one before the end of a chatter, down to 1e-8 of the time
// since the event before it.
inline double edge(const std::vector<Event> &events, double until, Draw &draw) {
  std::vector<std::size_t> ends;
  for (std::size_t k = 1; k < events.size(); ++k)
    if (events[k].kind == EventKind::stick && events[k].taken.impulse > 0.0) ends.push_back(k);
  if (ends.empty() || draw.one_in(3)) return draw.uniform(0.01, 1.0) * until;
  const std::size_t k = ends[draw.below(static_cast<unsigned>(ends.size()))];
  const double first = events[k - std::min<std::size_t>(k, draw.below(20))].time;
  return events[k].time - (events[k].time - first) * draw.spread(1e-8, 1.0) - 1e-9;
}

}  // namespace vibro_impact::testing
