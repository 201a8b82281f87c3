// Pairs of events on two masses (Table I and Section 3.3 of the paper): dual grazing, dual
// sticking, double impact, grazing-sticking, grazing-impact, sticking-impact.
//
// A mass sticks over an interval, from its stick to its release; it grazes or impacts at an
// instant. Two contacts pair when their times agree, a contact and a sticking phase when the phase
// contains the contact, two sticking phases when they overlap.
//
// The paper asks whether an impact of one mass while the other sticks is a double impact, the other
// being in contact with its stop too. It is not: the sticking mass has no impact at that instant,
// it is held, and that its sticking phase was reached through infinitely many impacts does not
// change this. Such an impact is a sticking-impact, and sticking takes precedence wherever both
// readings would apply, that is, within the tolerance of the end of a chatter as well.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <tuple>
#include <vector>

#include "pressing_force.hpp"
#include "record.hpp"
#include "scene.hpp"

namespace vibro_impact {

// The six entries of Table I, in its order.
enum class EventPair {
  dual_grazing,
  dual_sticking,
  double_impact,
  grazing_sticking,
  grazing_impact,
  sticking_impact
};

constexpr std::array<EventPair, 6> all_event_pairs{
    EventPair::dual_grazing,     EventPair::dual_sticking,  EventPair::double_impact,
    EventPair::grazing_sticking, EventPair::grazing_impact, EventPair::sticking_impact};

// The paper's abbreviation: DG, DS, DI, GS, GI, SI.
inline const char *abbreviation(EventPair kind) {
  constexpr std::array<const char *, 6> names{"DG", "DS", "DI", "GS", "GI", "SI"};
  return names[static_cast<std::size_t>(kind)];
}

// The tolerances, non-dimensional. A mass pulled off by a force of 0.1 meets a stop that is 1e-15
// short of its turning point at a speed of 1e-8 and a time 1e-7 off: grazing cannot be told from
// impact more sharply than that in double precision.
struct PairTolerances {
  double time = 1e-6;   // events at most this far apart are simultaneous
  double speed = 1e-6;  // contacts at most this fast may be grazing
  double force = 1e-9;  // ... if the mass is pulled off its stop by more than this
};

// An event and the force that presses its mass into the stop (pressing_force.hpp) right after it.
struct PressedEvent {
  Event event;
  double press = 0.0;
};

// The pressing force on a mass (from 1) at its stop on `side`. Throws std::invalid_argument when
// the mass has no stop on that side.
inline double press_at_stop(const Scene &scene, int mass, Side side, const Moment &moment) {
  const auto stop =
      std::find_if(scene.stops.begin(), scene.stops.end(), [mass, side](const Stop &candidate) {
        return candidate.mass == mass && candidate.side == side;
      });
  if (stop == scene.stops.end())
    throw std::invalid_argument(
        fmt::format("mass {}: it has no {} stop", mass, side == Side::upper ? "upper" : "lower"));
  return pressing_force(scene, *stop, moment.instant.phase, moment.displacement, moment.velocity);
}

// Every event from time `from` on, with the pressing force of each contact.
struct PressedEventRecorder {
  Scene scene;
  double from = 0.0;
  std::vector<PressedEvent> events = {};

  void event(const Event &event, const Moment &moment) {
    if (event.time < from) return;
    const bool contact = event.kind == EventKind::impact;
    events.push_back({event, contact ? press_at_stop(scene, event.mass, event.side, moment) : 0.0});
  }
};

// One pair. In a mixed pair `mass` (from 1) has the event named first and `other` the second (GS:
// `mass` grazes, `other` sticks); in a pair of equals `mass` < `other`. `from` and `to` are the
// bounds of the common sticking phase (DS), the time of the contact (GS, SI) or the two times of
// contact in order (DG, DI, GI). A bound the record does not contain is infinite.
struct PairedEvents {
  EventPair kind = EventPair::double_impact;
  int mass = 1, other = 2;
  double from = 0.0, to = 0.0;
  friend bool operator==(const PairedEvents &, const PairedEvents &) = default;
};

namespace detail {

// A sticking phase of one mass, and a contact that either grazes or hits.
struct HeldPhase {
  int mass;
  double from, to;
};
struct TimedContact {
  int mass;
  double time;
  bool grazing;
};

inline std::vector<HeldPhase> held_phases(const std::vector<PressedEvent> &events) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::vector<HeldPhase> phases;
  const auto open = [&phases](int mass) {
    return std::find_if(phases.begin(), phases.end(), [mass](const HeldPhase &phase) {
      return phase.mass == mass && phase.to == infinity;
    });
  };
  // Masses that stick as the record begins.
  if (!events.empty()) {
    const Event &first = events.front().event;
    for (std::size_t i = 0; i < first.held.size(); ++i)
      if (first.held[i] != 0) phases.push_back({static_cast<int>(i) + 1, -infinity, infinity});
    if (first.kind == EventKind::release) phases.push_back({first.mass, -infinity, infinity});
  }
  for (const auto &[event, press] : events) {
    const auto phase = open(event.mass);
    if (event.kind == EventKind::stick) {
      if (phase == phases.end())
        phases.push_back({event.mass, event.time, infinity});
      else  // it came to stick with the first event
        phase->from = event.time;
    } else if (event.kind == EventKind::release && phase != phases.end()) {
      phase->to = event.time;
    }
  }
  return phases;
}

// A slow contact is grazing only when the mass is pulled off the stop: the slow impacts of a late
// chatter are pressed into it, those about an equilibrium at the stop (Figure 5(c)) are neither.
inline std::vector<TimedContact> timed_contacts(const std::vector<PressedEvent> &events,
                                                const PairTolerances &tolerances) {
  std::vector<TimedContact> contacts;
  for (const auto &[event, press] : events)
    if (event.kind == EventKind::impact)
      contacts.push_back(
          {event.mass, event.time,
           std::abs(event.velocity_before) <= tolerances.speed && press < -tolerances.force});
  return contacts;
}

}  // namespace detail

// The pairs of events among `events` (in order of time, as a run reports them), in order of time,
// for every two masses of the chain. Throws std::invalid_argument for a tolerance that is negative
// or not finite.
inline std::vector<PairedEvents> event_pairs(const std::vector<PressedEvent> &events,
                                             const PairTolerances &tolerances = {}) {
  for (double tolerance : {tolerances.time, tolerances.speed, tolerances.force})
    detail::require(std::isfinite(tolerance) && tolerance >= 0.0,
                    "tolerance = {}: must be non-negative and finite", tolerance);
  const auto phases = detail::held_phases(events);
  const auto contacts = detail::timed_contacts(events, tolerances);
  std::vector<PairedEvents> pairs;

  for (auto a = phases.begin(); a != phases.end(); ++a)
    for (auto b = a + 1; b != phases.end(); ++b) {
      const double from = std::max(a->from, b->from), to = std::min(a->to, b->to);
      if (a->mass != b->mass && to - from > tolerances.time)
        pairs.push_back({EventPair::dual_sticking, std::min(a->mass, b->mass),
                         std::max(a->mass, b->mass), from, to});
    }

  const auto within = [&tolerances](const detail::HeldPhase &phase, double time) {
    return phase.from - time <= tolerances.time && time - phase.to <= tolerances.time;
  };
  for (const auto &contact : contacts)
    for (const auto &phase : phases) {
      if (phase.mass == contact.mass || !within(phase, contact.time)) continue;
      if (contact.grazing)
        pairs.push_back(
            {EventPair::grazing_sticking, contact.mass, phase.mass, contact.time, contact.time});
      else
        pairs.push_back(
            {EventPair::sticking_impact, phase.mass, contact.mass, contact.time, contact.time});
    }

  const auto sticks_during = [&](int mass, double time) {
    return std::any_of(phases.begin(), phases.end(), [&](const detail::HeldPhase &phase) {
      return phase.mass == mass && within(phase, time);
    });
  };
  for (auto a = contacts.begin(); a != contacts.end(); ++a)
    for (auto b = a + 1; b != contacts.end() && b->time - a->time <= tolerances.time; ++b) {
      if (a->mass == b->mass || sticks_during(a->mass, b->time) || sticks_during(b->mass, a->time))
        continue;
      if (a->grazing != b->grazing)
        pairs.push_back({EventPair::grazing_impact, a->grazing ? a->mass : b->mass,
                         a->grazing ? b->mass : a->mass, a->time, b->time});
      else
        pairs.push_back({a->grazing ? EventPair::dual_grazing : EventPair::double_impact,
                         std::min(a->mass, b->mass), std::max(a->mass, b->mass), a->time, b->time});
    }

  const auto key = [](const PairedEvents &pair) {
    return std::tuple(pair.from, pair.to, pair.kind, pair.mass, pair.other);
  };
  std::sort(pairs.begin(), pairs.end(),
            [&key](const PairedEvents &a, const PairedEvents &b) { return key(a) < key(b); });
  // A contact within the tolerance of two phases of one mass pairs with that mass once.
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

// The greatest force, over a forcing period, that presses both masses of a two-mass chain into
// their stops `first` and `second` at once (the smaller of the two forces). Positive if and only if
// dual sticking is possible.
//
// With both masses at rest at their stops, u = cos(Omega t), and A = (A1, A2), Eqs. 12-13 read
//   F1 = k2 (s2 - s1) - k1 s1 + A1 u,   F2 = k2 (s1 - s2) + A2 u,
// and dual sticking needs sigma1 F1 > 0 and sigma2 F2 > 0 at the same u in [-1, 1]. The condition
// is sufficient, too: both forces stay positive for some time about such an instant, two masses at
// rest at their stops stay there for that time, and so do, after complete chatter, masses that
// arrive slowly enough. (It does not say that a given initial state leads there.)
//
// For A2 = 0, the paper's case, F2 is constant: sigma2 (s1 - s2) > 0, which for an upper stop is
// s2 < s1, and sigma1 (k2 (s2 - s1) - k1 s1) + |A1| > 0. At s2 = s1, Figure 5(c), F2 is zero: mass
// 2 bounces about its own equilibrium at a constant interval, for ever, and does not stick.
//
// Throws std::invalid_argument unless the chain has two masses and the stops are on masses 1 and 2.
inline double greatest_common_press(const Scene &scene, const Stop &first, const Stop &second) {
  detail::require(scene.masses() == 2, "masses = {}: the condition is for two masses",
                  scene.masses());
  detail::require(first.mass == 1 && second.mass == 2,
                  "stops on masses {} and {}: must be on 1 and 2", first.mass, second.mass);
  const double sigma1 = sign(first.side), sigma2 = sign(second.side);
  const double link = scene.stiffness[1] * (second.position - first.position);
  const double a1 = scene.forced() ? scene.amplitude[0] : 0.0;
  const double a2 = scene.forced() ? scene.amplitude[1] : 0.0;
  const double press1 = sigma1 * (link - scene.stiffness[0] * first.position),
               press2 = -sigma2 * link;
  const double slope1 = sigma1 * a1, slope2 = sigma2 * a2;
  const auto smaller = [&](double u) { return std::min(press1 + slope1 * u, press2 + slope2 * u); };
  // The smaller of two straight lines is greatest at an end of [-1, 1] or where they cross.
  double greatest = std::max(smaller(1.0), scene.omega == 0.0 ? smaller(1.0) : smaller(-1.0));
  const double crossing = (press2 - press1) / (slope1 - slope2);
  if (scene.omega > 0.0 && std::abs(crossing) <= 1.0)
    greatest = std::max(greatest, smaller(crossing));
  return greatest;
}

}  // namespace vibro_impact
