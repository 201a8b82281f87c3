#include "vibro_impact/analysis/event_pairs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "motion_state.hpp"
#include "tolerances.hpp"
#include "vibro_impact/analysis/pressing_force.hpp"

namespace vibro_impact {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// A sticking phase of one mass. A bound that the record does not contain is infinite.
struct StickingPhase {
  int mass;
  double from, to;
};

// A contact that either grazes or hits.
struct TimedContact {
  int mass;
  double time;
  bool grazing;
};

// The phases under way as the record begins: those of the masses released at the first instant, and
// of the masses held after it. One of the latter may have come to stick there (sticking_phases_in).
std::vector<StickingPhase> phases_under_way(const std::vector<PressedEvent> &events) {
  std::vector<StickingPhase> phases;
  if (events.empty()) return phases;
  const Event &first = events.front().event;
  for (const auto &[event, press] : events)
    if (event.time == first.time && event.kind == EventKind::release)
      phases.push_back({event.mass, -infinity, infinity});
  for (std::size_t i = 0; i < first.held.size(); ++i)
    if (first.held[i] != 0) phases.push_back({static_cast<int>(i) + 1, -infinity, infinity});
  return phases;
}

std::vector<StickingPhase> sticking_phases_in(const std::vector<PressedEvent> &events) {
  std::vector<StickingPhase> phases = phases_under_way(events);
  for (const auto &[event, press] : events) {
    const int mass = event.mass;
    const auto open = std::find_if(phases.begin(), phases.end(), [mass](const auto &phase) {
      return phase.mass == mass && phase.to == infinity;
    });
    if (event.kind == EventKind::stick) {
      if (open == phases.end())
        phases.push_back({mass, event.time, infinity});
      else  // the mass came to stick at the first instant
        open->from = event.time;
    } else if (event.kind == EventKind::release && open != phases.end()) {
      open->to = event.time;
    }
  }
  return phases;
}

// A slow contact is grazing only when the mass is pulled off the stop. In the slow impacts of a
// late chatter the mass is pressed into it; in those about an equilibrium at the stop (Figure 5(c))
// the force is zero to rounding.
std::vector<TimedContact> timed_contacts(const std::vector<PressedEvent> &events) {
  std::vector<TimedContact> contacts;
  for (const auto &[event, press] : events)
    if (event.kind == EventKind::impact)
      contacts.push_back({event.mass, event.time,
                          std::abs(event.velocity_before) <= slow_contact && press < -pulled_off});
  return contacts;
}

bool contains(const StickingPhase &phase, double time) {
  return phase.from - time <= simultaneous && time - phase.to <= simultaneous;
}

bool sticks_at(int mass, double time, const std::vector<StickingPhase> &phases) {
  return std::any_of(phases.begin(), phases.end(), [&](const StickingPhase &phase) {
    return phase.mass == mass && contains(phase, time);
  });
}

// A pair of two events of one kind has its masses in order.
PairedEvents pair_of(EventPair kind, int one, int another, double from, double to) {
  return {kind, std::min(one, another), std::max(one, another), from, to};
}

void pair_phases(const std::vector<StickingPhase> &phases, std::vector<PairedEvents> &pairs) {
  for (auto a = phases.begin(); a != phases.end(); ++a)
    for (auto b = a + 1; b != phases.end(); ++b) {
      const double from = std::max(a->from, b->from), to = std::min(a->to, b->to);
      if (a->mass != b->mass && to - from > simultaneous)
        pairs.push_back(pair_of(EventPair::dual_sticking, a->mass, b->mass, from, to));
    }
}

void pair_contacts_with_phases(const std::vector<TimedContact> &contacts,
                               const std::vector<StickingPhase> &phases,
                               std::vector<PairedEvents> &pairs) {
  for (const auto &[mass, time, grazing] : contacts)
    for (const StickingPhase &phase : phases) {
      if (phase.mass == mass || !contains(phase, time)) continue;
      if (grazing)
        pairs.push_back({EventPair::grazing_sticking, mass, phase.mass, time, time});
      else
        pairs.push_back({EventPair::sticking_impact, phase.mass, mass, time, time});
    }
}

PairedEvents pair_of(const TimedContact &a, const TimedContact &b) {
  if (a.grazing == b.grazing)
    return pair_of(a.grazing ? EventPair::dual_grazing : EventPair::double_impact, a.mass, b.mass,
                   a.time, b.time);
  const int grazing = a.grazing ? a.mass : b.mass, hitting = a.grazing ? b.mass : a.mass;
  return {EventPair::grazing_impact, grazing, hitting, a.time, b.time};
}

void pair_contacts(const std::vector<TimedContact> &contacts,
                   const std::vector<StickingPhase> &phases, std::vector<PairedEvents> &pairs) {
  for (auto a = contacts.begin(); a != contacts.end(); ++a)
    for (auto b = a + 1; b != contacts.end() && b->time - a->time <= simultaneous; ++b)
      if (a->mass != b->mass && !sticks_at(a->mass, b->time, phases) &&
          !sticks_at(b->mass, a->time, phases))
        pairs.push_back(pair_of(*a, *b));
}

// Sorts the pairs by time and removes repeated ones: a contact within the tolerance of two phases
// of one mass pairs with that mass once.
void sort_and_unite(std::vector<PairedEvents> &pairs) {
  const auto key = [](const PairedEvents &pair) {
    return std::tuple(pair.from, pair.to, pair.kind, pair.mass, pair.other);
  };
  std::sort(pairs.begin(), pairs.end(),
            [&key](const PairedEvents &a, const PairedEvents &b) { return key(a) < key(b); });
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
}

}  // namespace

const char *abbreviation(EventPair kind) {
  constexpr std::array<const char *, 6> names{"DG", "DS", "DI", "GS", "GI", "SI"};
  const auto k = static_cast<std::size_t>(kind);
  require(k < names.size(), "pair of events = ", k, ": there are 0 to ", names.size() - 1);
  return names[k];
}

void PressedEventRecorder::event(const Event &event, const Moment &moment) {
  if (event.time < from) return;
  if (event.kind != EventKind::impact) return events.push_back({event, 0.0});
  require(event.stop < scene.stops.size(), "stop ", event.stop, ": the scene has ",
          scene.stops.size(), " stops");
  events.push_back(
      {event, pressing_force(scene, scene.stops[event.stop], state_at(moment, event.held))});
}

std::vector<PairedEvents> event_pairs(const std::vector<PressedEvent> &events) {
  const std::vector<StickingPhase> phases = sticking_phases_in(events);
  const std::vector<TimedContact> contacts = timed_contacts(events);
  std::vector<PairedEvents> pairs;
  pair_phases(phases, pairs);
  pair_contacts_with_phases(contacts, phases, pairs);
  pair_contacts(contacts, phases, pairs);
  sort_and_unite(pairs);
  return pairs;
}

}  // namespace vibro_impact
