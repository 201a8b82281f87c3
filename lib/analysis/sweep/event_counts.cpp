#include "event_counts.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/orbits/motion_state.hpp"
#include "vibro_impact/analysis/settle.hpp"

namespace vibro_impact {

namespace {

bool rebounds(const Scene &scene, const Event &event) {
  return law_of(scene, stop_of(scene, event)).at_rest() > 0.0;
}

bool dual_sticking(const Held &held) {
  return std::count_if(held.begin(), held.end(), [](signed char h) { return h != 0; }) > 1;
}

void require_fits(const Scene &scene, const Event &event) {
  require_mass(event.mass, scene.masses());
  require(event.stop >= 1 && static_cast<std::size_t>(event.stop) <= scene.stops.size(), "stop ",
          event.stop, ": the scene has ", scene.stops.size());
}

}  // namespace

// Leaves out the impacts of complete chatters: those before a stick at the same stop, each slower
// than the one before. The events repeat, so that a chatter under way at their end goes on at their
// beginning, where Event::falling may begin anew. A chatter begins one impact earlier where two
// impacts become equally fast: for the comparison of orbits, all impacts at the stop between a
// stick and the event before it are left out.
std::vector<Event> without_chatters(const Scene &scene, const std::vector<Event> &events,
                                    bool all_before_sticks) {
  std::vector<Event> twice = events;
  twice.insert(twice.end(), events.begin(), events.end());
  std::vector<bool> left_out(twice.size(), false);
  for (std::size_t k = 0; k < twice.size(); ++k) {
    const Event &stick = twice[k];
    if (stick.kind != EventKind::stick || !rebounds(scene, stick)) continue;
    double slower = 0.0;  // speed of the impact after the one looked at
    for (std::size_t j = k; j-- > 0;) {
      const Event &before = twice[j];
      if (before.mass != stick.mass) continue;
      if (changes_contact_mode(before.kind) || before.stop != stick.stop) break;
      const double speed = std::abs(before.velocity_before);
      if (speed <= slower && !all_before_sticks) break;
      left_out[j] = true;
      slower = speed;
    }
  }
  std::vector<Event> kept;
  for (std::size_t k = 0; k < events.size(); ++k)
    if (!left_out[k]) kept.push_back(events[k]);
  return kept;
}

bool same_events(const std::vector<Event> &a, const std::vector<Event> &b) {
  if (a.size() != b.size()) return false;
  std::vector<Event> twice = b;
  twice.insert(twice.end(), b.begin(), b.end());
  const auto same_kind = [](const Event &one, const Event &other) {
    return one.kind == other.kind && one.stop == other.stop;
  };
  // clang 14 does not compile std::ranges::search of libstdc++ 12.
  return a.empty() ||
         std::search(twice.begin(), twice.end(), a.begin(), a.end(), same_kind) != twice.end();
}

EventCounts counts_of(const Scene &scene, const std::vector<Event> &events, int periods,
                      const Held &held) {
  check(scene);
  require(periods >= 1, "periods = ", periods, ": must be positive");
  require_held(scene, held);
  for (const Event &event : events) require_fits(scene, event);
  const std::vector<int> none(scene.mass.size(), 0);
  EventCounts counts{periods, none, none, dual_sticking(held)};
  for (const Event &event : without_chatters(scene, events)) {
    const auto mass = static_cast<std::size_t>(event.mass - 1);
    if (event.kind == EventKind::impact) ++counts.impacts[mass];
    if (event.kind == EventKind::stick) ++counts.sticks[mass];
    counts.dual_sticking = counts.dual_sticking || dual_sticking(event.held);
  }
  return counts;
}

}  // namespace vibro_impact
