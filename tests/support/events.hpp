// Events of runs, as many tests read them.
#pragma once

#include <functional>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "vibro_impact/vibro_impact.hpp"

namespace vibro_impact::testing {

// Chatter is resolved until what is left of it lies below rounding.
inline const RunOptions all_impacts{.limit_below_speed = 0.0};

// The events of a run that comes to its end, from a start on.
inline std::vector<Event> events_from(const Scene &scene, const MotionState &start, double until,
                                      const RunOptions &options = {}) {
  EventRecorder recorder(-infinity);
  require_complete(Simulation(scene, start, options).advance(until, recorder));
  return recorder.events;
}

// From the scene's own start; those from time `from` on.
inline std::vector<Event> events_of(const Scene &scene, double from, double until,
                                    const RunOptions &options = {}) {
  EventRecorder recorder(from);
  require_complete(simulate(scene, until, options, recorder));
  return recorder.events;
}

// A time between the last impact of a run that ends with a stick and this stick, the limit of the
// chatter: a quarter of the way.
inline double time_inside_chatter(const Scene &scene, double until,
                                  const RunOptions &options = {}) {
  const std::vector<Event> events = events_of(scene, 0.0, until, options);
  if (events.size() < 2 || events.back().kind != EventKind::stick)
    throw std::runtime_error("the run ends with no stick after a chatter");
  const double latest = events[events.size() - 2].time;
  return latest + 0.25 * (events.back().time - latest);
}

// Calls a function with each event that EventRecorder records, and asks for the end of the run once
// it has returned true.
struct AtEvents : Recorder {
  std::function<bool(const Event &, const Moment &)> is_last;
  bool ended = false;

  explicit AtEvents(std::function<bool(const Event &, const Moment &)> function)
      : is_last(std::move(function)) {
  }
  double slowest_impact(double first, double) const override {
    return slowest_listed({}, first);
  }
  void event(const Event &event, const Moment &moment) override {
    ended = is_last(event, moment) || ended;
  }
  bool done() const override {
    return ended;
  }
};

// The events of a kind: of one mass, or of every mass.
inline std::vector<Event> select(const std::vector<Event> &events, EventKind kind,
                                 std::optional<int> mass = std::nullopt) {
  std::vector<Event> selected;
  for (const Event &event : events)
    if (event.kind == kind && (!mass || event.mass == *mass)) selected.push_back(event);
  return selected;
}

}  // namespace vibro_impact::testing
