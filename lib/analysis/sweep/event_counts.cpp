#include "event_counts.hpp"

#include <algorithm>

#include "vibro_impact/analysis/chatters.hpp"

namespace vibro_impact {

namespace {

bool rebounds(const Scene &scene, std::size_t stop) {
  return law_of(scene, scene.stops[stop]).at_rest() > 0.0;
}

bool dual_sticking(const Held &held) {
  return std::count_if(held.begin(), held.end(), [](signed char h) { return h != 0; }) > 1;
}

}  // namespace

std::vector<Event> without_chatters(const Scene &scene, const std::vector<Event> &events) {
  std::vector<Event> twice = events;
  twice.insert(twice.end(), events.begin(), events.end());
  std::vector<bool> left_out(twice.size(), false);
  for (const Chatter &chatter : chatters_of(twice))
    if (chatter.complete && rebounds(scene, chatter.stop))
      for (const std::size_t k : chatter.impacts) left_out[k] = true;
  std::vector<Event> kept;
  for (std::size_t k = 0; k < events.size(); ++k)
    if (!left_out[k]) kept.push_back(events[k]);
  return kept;
}

EventCounts counts_of(const Scene &scene, const std::vector<Event> &events, int periods,
                      const Held &held) {
  const std::vector<int> none(scene.mass.size(), 0);
  EventCounts counts{periods, none, none, none, dual_sticking(held)};
  for (const Event &event : without_chatters(scene, events)) {
    const auto mass = static_cast<std::size_t>(event.mass - 1);
    if (event.kind == EventKind::impact) ++counts.impacts[mass];
    if (event.kind == EventKind::stick) ++counts.sticks[mass];
    if (event.kind == EventKind::stick && rebounds(scene, event.stop)) ++counts.chatters[mass];
    counts.dual_sticking = counts.dual_sticking || dual_sticking(event.held);
  }
  return counts;
}

}  // namespace vibro_impact
