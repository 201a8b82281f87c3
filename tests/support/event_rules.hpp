// The rules for the next event of a run, of which it lists the impacts that EventRecorder records.
#pragma once

#include <fmt/format.h>

#include <optional>
#include <string>
#include <vector>

#include "vibro_impact/vibro_impact.hpp"

namespace vibro_impact::testing {

// Time never falls. Only a free mass has impacts and sticks, so that the release of a mass follows
// its stick before its next impact. Only a held mass is released, from the side at which it is
// held. A mass is neither held nor free for no time, but where it crosses from a stop to the other
// one of a slot too narrow to take time. The recorded contact mode follows from all events up to an
// instant, at which several masses may stick or be released. An impact obeys the law of the stop,
// which has the mass and the side of the event. A mass that loses speed does not come back as fast
// as before in no time for ever. The rounding of a force next to its root does that some hundred
// times.
struct EventRules : Recorder {
  const Scene &scene;
  Held held = Held(scene.mass.size(), 0);
  std::vector<std::optional<Instant>> changed = std::vector<std::optional<Instant>>(held.size());
  Held left = held;  // the side of the latest release of each mass
  double last = 0.0;
  std::vector<int> as_fast = std::vector<int>(scene.stops.size());  // such impacts at each stop
  Held recorded = held;                                             // with the latest event,
  Instant recorded_at = {};                                         // at this instant
  std::vector<Event> events = {};
  std::string broken = {};

  explicit EventRules(const Scene &of) : scene(of) {
  }
  double slowest_impact(double first, double) const override {
    return slowest_listed({}, first);
  }
  void event(const Event &event, const Moment &moment) override {
    events.push_back(event);
    if (!broken.empty()) return;
    if (const char *fault = fault_of(event))
      broken =
          fmt::format("{}: {} of mass {} at {}", fault, name(event.kind), event.mass, event.time);
    last = event.time;
    for (const Stop &stop : scene.stops)
      if (recorded[static_cast<std::size_t>(stop.mass - 1)] ==
              static_cast<signed char>(stop.side) &&
          moment.displacement(stop.mass) != stop.position)
        broken = "held off its stop";
  }

 private:
  // The first rule that the event breaks; takes over the contact mode.
  const char *fault_of(const Event &event) {
    if (!(event.time >= last)) return "time falls";
    if (recorded_at < event.instant && recorded != held) return "contact mode of the event before";
    if (event.stop < 1 || static_cast<std::size_t>(event.stop) > scene.stops.size()) return "stop";
    const Stop &stop = stop_of(scene, event);
    if (stop.mass != event.mass || stop.side != event.side) return "stop of another mass or side";
    const double sigma = sign(event.side);
    const auto side = static_cast<signed char>(event.side);
    const auto i = static_cast<std::size_t>(event.mass - 1);
    const bool changed_now = changed[i] && !(*changed[i] < event.instant);
    switch (event.kind) {
      case EventKind::impact:
        if (held[i] != 0) return "impact of a held mass";
        if (!(sigma * event.velocity_before >= 0.0)) return "impact while leaving";
        if (event.velocity_after !=
            -sigma * law_of(scene, stop).after(sigma * event.velocity_before))
          return "impact law";
        if (int &count = as_fast[static_cast<std::size_t>(event.stop - 1)];
            event.falling > 0 || event.time != last ||
            event.velocity_after == -event.velocity_before)
          count = 0;
        else if (++count > 5000)
          return "as fast as before in no time";
        break;
      case EventKind::stick:
        if (held[i] != 0) return "stick of a held mass";
        if (changed_now && left[i] == side) return "stick at the instant of a release";
        held[i] = side;
        changed[i] = event.instant;
        break;
      case EventKind::release:
        if (held[i] != side) return "release of a mass not held there";
        if (changed_now) return "release at the instant of a stick";
        held[i] = 0;
        left[i] = side;
        changed[i] = event.instant;
        break;
    }
    recorded = event.held;
    recorded_at = event.instant;
    return recorded[i] == held[i] ? nullptr : "contact mode";
  }
};

}  // namespace vibro_impact::testing
