// Events of runs, as many tests read them.
#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <functional>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "vibro_impact/vibro_impact.hpp"

namespace vibro_impact::testing {

// Chatter is resolved until what is left of it lies below rounding.
inline const RunOptions all_impacts{.limit_below_speed = 0.0};

// The dampers are strong enough that an impact of one mass lets go of the other by a jump of its
// hold force.
inline Scene released_by_a_jump() {
  return {.mass = {1.0, 1.0},
          .stiffness = {1.0, 1.0},
          .beta = 0.7,
          .amplitude = {0.8, 0.3},
          .omega = 0.5,
          .restitution = 0.5,
          .stops = {{1, Side::upper, 0.2}, {2, Side::upper, 0.2}}};
}

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

// Runs that may take limits stick and release at the times of runs that resolve every impact.
inline void expect_holds_of_all_impacts(const Scene &scene, double until, double within) {
  std::vector<Event> held[2];
  for (const bool all : {false, true})
    for (const Event &event : events_of(scene, 0.0, until, all ? all_impacts : RunOptions{}))
      if (event.kind != EventKind::impact) held[all].push_back(event);
  ASSERT_EQ(held[0].size(), held[1].size());
  for (std::size_t i = 0; i < held[0].size(); ++i) {
    EXPECT_EQ(held[0][i].mass, held[1][i].mass);
    EXPECT_NEAR(held[0][i].time, held[1][i].time, within);
  }
}

}  // namespace vibro_impact::testing
