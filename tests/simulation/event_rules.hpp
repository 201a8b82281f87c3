// What one event of a run allows the next one to be.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "vibro_impact/vibro_impact.hpp"

namespace vibro_impact::testing {

// What one event allows the next one to be: time never falls; only a free mass has impacts and
// sticks, so that every stick is followed by its release before the next impact of that mass; only
// a held mass is released, from the side it is held at; neither its hold nor its freedom lasts no
// time; the contact mode told is the one that follows from all events before, where several masses
// stick or are released at one instant from all of those; the impact law of the stop, which is one
// of the mass and side told.
struct EventRules {
  const Scene &scene;
  Held held = Held(scene.mass.size(), 0);
  std::vector<std::optional<Instant>> changed = std::vector<std::optional<Instant>>(held.size());
  double last = 0.0;
  Held told = held;      // with the latest event,
  Instant told_at = {};  // at this instant
  std::vector<Event> events = {};
  std::string broken = {};

  void event(const Event &event, const Moment &moment) {
    events.push_back(event);
    if (!broken.empty()) return;
    if (const char *fault = fault_of(event))
      broken =
          fmt::format("{}: {} of mass {} at {}", fault, name(event.kind), event.mass, event.time);
    last = event.time;
    for (const Stop &stop : scene.stops)
      if (told[static_cast<std::size_t>(stop.mass - 1)] == static_cast<signed char>(stop.side) &&
          moment.displacement(stop.mass) != stop.position)
        broken = "held off its stop";
  }

 private:
  // The first rule that the event breaks; takes over the contact mode.
  const char *fault_of(const Event &event) {
    if (!(event.time >= last)) return "time falls";
    if (told_at < event.instant && told != held) return "contact mode of the event before";
    if (event.stop < 1 || static_cast<std::size_t>(event.stop) > scene.stops.size()) return "stop";
    const Stop &stop = stop_of(scene, event);
    if (stop.mass != event.mass || stop.side != event.side) return "stop of another mass or side";
    const double sigma = sign(event.side);
    const auto side = static_cast<signed char>(event.side);
    const auto i = static_cast<std::size_t>(event.mass - 1);
    if (event.kind == EventKind::impact) {
      if (held[i] != 0) return "impact of a held mass";
      if (!(sigma * event.velocity_before >= 0.0)) return "impact while leaving";
      const double r = stop.restitution.value_or(scene.restitution);
      if (event.velocity_after != -(r * event.velocity_before)) return "impact law";
    } else {
      const bool sticks = event.kind == EventKind::stick;
      if (sticks && held[i] != 0) return "stick of a held mass";
      if (!sticks && held[i] != side) return "release of a mass not held there";
      if (changed[i] && !(*changed[i] < event.instant))
        return sticks ? "stick at the instant of a release" : "release at the instant of a stick";
      held[i] = sticks ? side : static_cast<signed char>(0);
      changed[i] = event.instant;
    }
    told = event.held;
    told_at = event.instant;
    return told[i] == held[i] ? nullptr : "contact mode";
  }
};

}  // namespace vibro_impact::testing
