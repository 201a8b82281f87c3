#include "vibro_impact/analysis/event_pairs.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "motion.hpp"
#include "orbit_tolerances.hpp"

namespace vibro_impact {

namespace {

// A mass at its stop grazes, sticks or impacts. The order is that of the names of mixed pairs.
enum class ContactKind { grazing, sticking, impact };

// A grazing contact or an impact has from = to. A bound of a sticking phase that the record does
// not contain is infinite.
struct StopContact {
  ContactKind kind;
  int mass;
  double from, to;
};

// A slow contact is grazing only when the mass is pulled off the stop. In the slow impacts of a
// late chatter the mass is pressed into it; in those about an equilibrium at the stop (Figure 5(c))
// the force is zero to rounding.
bool grazes(const PressedEvent &impact) {
  return std::abs(impact.event.velocity_before) <= slow_contact * impact.speed_scale &&
         impact.press < -pulled_off * impact.force_scale;
}

// A sticking phase is under way as the record begins if its mass is held then. Where the contact
// mode at the start is not known, a mass is held then if it is held after the first event, or if a
// release comes without a stick before it. A mass held after the first event may have stuck at that
// instant.
std::vector<StopContact> contacts_of(const std::vector<PressedEvent> &events,
                                     const std::optional<Held> &start) {
  std::vector<StopContact> contacts;
  const Held held_at_first = start.value_or(events.empty() ? Held{} : events.front().event.held);
  for (std::size_t i = 0; i < held_at_first.size(); ++i)
    if (held_at_first[i] != 0)
      contacts.push_back({ContactKind::sticking, static_cast<int>(i) + 1, -infinity, infinity});
  for (const PressedEvent &pressed : events) {
    const Event &event = pressed.event;
    const auto phase =
        std::find_if(contacts.begin(), contacts.end(), [&](const StopContact &contact) {
          return contact.mass == event.mass && contact.to == infinity;
        });
    switch (event.kind) {
      case EventKind::impact: {
        const auto kind = grazes(pressed) ? ContactKind::grazing : ContactKind::impact;
        contacts.push_back({kind, event.mass, event.time, event.time});
        break;
      }
      case EventKind::stick:
        if (phase == contacts.end())
          contacts.push_back({ContactKind::sticking, event.mass, event.time, infinity});
        else  // the mass came to stick at the first instant
          phase->from = event.time;
        break;
      case EventKind::release:
        if (phase == contacts.end())
          contacts.push_back({ContactKind::sticking, event.mass, -infinity, event.time});
        else
          phase->to = event.time;
        break;
    }
  }
  return contacts;
}

bool sticks_at(int mass, double time, const std::vector<StopContact> &contacts, double tolerance) {
  return std::any_of(contacts.begin(), contacts.end(), [&](const StopContact &contact) {
    return contact.kind == ContactKind::sticking && contact.mass == mass &&
           contact.from - time <= tolerance && time - contact.to <= tolerance;
  });
}

EventPair kind_of(ContactKind first, ContactKind second) {
  using enum EventPair;
  constexpr EventPair pairs[3][3] = {{dual_grazing, grazing_sticking, grazing_impact},
                                     {grazing_sticking, dual_sticking, sticking_impact},
                                     {grazing_impact, sticking_impact, double_impact}};
  return pairs[static_cast<std::size_t>(first)][static_cast<std::size_t>(second)];
}

// The pair of two contacts of different masses. Returns nullopt if they do not coincide, and for
// two contacts at an instant one of which belongs to a sticking phase. Times that differ by no more
// than the tolerance agree.
std::optional<PairedEvents> pair_of(StopContact a, StopContact b,
                                    const std::vector<StopContact> &contacts, double tolerance) {
  if (std::pair(b.kind, b.mass) < std::pair(a.kind, a.mass)) std::swap(a, b);
  const bool a_sticks = a.kind == ContactKind::sticking, b_sticks = b.kind == ContactKind::sticking;
  const double begin = std::max(a.from, b.from), end = std::min(a.to, b.to);
  PairedEvents pair{begin, end, kind_of(a.kind, b.kind), a.mass, b.mass};
  if (a_sticks && b_sticks) return end - begin > tolerance ? std::optional(pair) : std::nullopt;
  if (begin - end > tolerance) return std::nullopt;
  if (a_sticks || b_sticks) {
    pair.from = pair.to = a_sticks ? b.from : a.from;
    return pair;
  }
  if (sticks_at(a.mass, b.from, contacts, tolerance) ||
      sticks_at(b.mass, a.from, contacts, tolerance))
    return std::nullopt;
  std::swap(pair.from, pair.to);  // the earlier of the two instants is the end of their overlap
  return pair;
}

}  // namespace

const char *abbreviation(EventPair kind) {
  constexpr std::array<const char *, 6> names{"DG", "DS", "DI", "GS", "GI", "SI"};
  const auto k = static_cast<std::size_t>(kind);
  require(k < names.size(), "pair of events = ", k, ": there are 0 to ", names.size() - 1);
  return names[k];
}

void PressedEventRecorder::check(const Scene &of_run) const {
  if (scene == of_run) return;  // the run has checked it
  vibro_impact::check(scene);
  require(scene.mass.size() == of_run.mass.size() && scene.stops.size() == of_run.stops.size(),
          "recorder: its scene has ", scene.masses(), " masses and ", scene.stops.size(),
          " stops, that of the run ", of_run.masses(), " and ", of_run.stops.size());
}

namespace {

// The event with what `grazes` asks of it. `frequencies` are the local ones, `state` is that after
// the event.
PressedEvent pressed_event(const Scene &scene, const std::vector<double> &frequencies,
                           const Event &event, const MotionState &state) {
  PressedEvent pressed{event};
  pressed.time_scale = 1.0 / std::ranges::min(frequencies);
  if (event.kind != EventKind::impact) return pressed;
  const std::size_t i = index_of(event.mass);
  const double frequency = frequencies[i], stiffness = scene.mass[i] * frequency * frequency;
  pressed.press = pressing_force_of(scene, stop_of(scene, event), state);
  pressed.force_scale = 0.0;
  for (const auto *force : {&scene.amplitude, &scene.sine, &scene.constant})
    pressed.force_scale += std::abs(entry_of(*force, i));
  for (std::size_t j = i > 0 ? i - 1 : 0; j <= i + 1 && j < scene.mass.size(); ++j)
    pressed.force_scale += stiffness * std::abs(state.displacement[j]);
  pressed.speed_scale = pressed.force_scale / (scene.mass[i] * frequency);
  return pressed;
}

}  // namespace

void PressedEventRecorder::event(const Event &event, const Moment &moment) {
  if (event.time < from) return;
  if (frequencies.empty()) frequencies = local_frequencies(scene);
  events.push_back(pressed_event(scene, frequencies, event, state_at(moment, event.held)));
}

std::vector<PairedEvents> pairs_of(const Motion &motion) {
  const std::vector<double> frequencies = local_frequencies(motion.scene);
  std::vector<PressedEvent> events;
  for (const Knot &knot : motion.knots)
    if (knot.event)
      events.push_back(pressed_event(motion.scene, frequencies, *knot.event, knot.state));
  return event_pairs(events, motion.start().held);
}

std::vector<PairedEvents> event_pairs(const std::vector<PressedEvent> &events,
                                      const std::optional<Held> &start) {
  const std::vector<StopContact> contacts = contacts_of(events, start);
  const double tolerance = events.empty() ? 0.0 : simultaneous * events.front().time_scale;
  std::vector<PairedEvents> pairs;
  for (auto a = contacts.begin(); a != contacts.end(); ++a)
    for (auto b = a + 1; b != contacts.end(); ++b)
      if (a->mass != b->mass)
        if (const auto pair = pair_of(*a, *b, contacts, tolerance)) pairs.push_back(*pair);
  std::sort(pairs.begin(), pairs.end());
  // A contact within the tolerance of two phases of one mass pairs with that mass once.
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

}  // namespace vibro_impact
