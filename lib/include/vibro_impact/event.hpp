/// \file
/// Events: a mass hits its stop, comes to stick at its stop, or is released from it.
#pragma once

#include <stdexcept>
#include <string>

#include "instant.hpp"
#include "scene.hpp"

namespace vibro_impact {

enum class EventKind { impact, stick, release };
inline constexpr EventKind all_event_kinds[] = {EventKind::impact, EventKind::stick,
                                                EventKind::release};

/// Returns "impact", "stick" or "release".
constexpr const char *name(EventKind kind) {
  switch (kind) {
    case EventKind::impact:
      return "impact";
    case EventKind::stick:
      return "stick";
    case EventKind::release:
      return "release";
  }
  throw std::logic_error("event: its kind is unknown");
}

/// True of a stick and of a release. The contact mode is the same before and after an impact.
constexpr bool changes_contact_mode(EventKind kind) {
  return kind != EventKind::impact;
}

/// The held masses of a contact mode as text: `-` for none, or `1`, `2`, `1+2`.
std::string contact_mode_name(const Held &held);

/// The sums of impacts at a stop: the impulse of the stop on its mass, away from the stop, and the
/// kinetic energy that is lost.
struct ImpactSum {
  double impulse = 0.0, energy = 0.0;

  bool operator==(const ImpactSum &) const = default;
  ImpactSum &operator+=(const ImpactSum &other) {
    impulse += other.impulse;
    energy += other.energy;
    return *this;
  }
  ImpactSum &operator-=(const ImpactSum &other) {
    impulse -= other.impulse;
    energy -= other.energy;
    return *this;
  }
};

/// One event of one mass. Simultaneous events are reported one after another with the same instant.
struct Event {
  EventKind kind = EventKind::impact;
  int stop = 1;  ///< from 1, in the order of Scene::stops
  int mass = 1;  ///< from 1
  Side side = Side::upper;
  Instant instant = {};
  double time = 0.0;
  double velocity_before = 0.0, velocity_after = 0.0;  ///< of an impact, towards +x; else 0
  int falling = 0;         ///< of an impact: those just before it, in a row of falling speeds
  bool by_a_jump = false;  ///< a release where the force jumped or began, not at a root
  Held held = {};          ///< the contact mode after the event
  /// The sums of an impact. A chatter that is carried to its limit has infinitely many impacts. Its
  /// event at the limit has the sums of those that no event before has reported. This event is the
  /// stick, or an impact with both velocities 0 if the mass does not stick.
  ImpactSum taken = {};

  bool operator==(const Event &) const = default;
};

/// The stop of an event of this scene.
inline const Stop &stop_of(const Scene &scene, const Event &event) {
  return scene.stops[static_cast<std::size_t>(event.stop - 1)];
}

}  // namespace vibro_impact
