// This library, with chatter carried to its limit and without.
#include <algorithm>
#include <limits>
#include <utility>

#include "method.hpp"
#include "vibro_impact/simulate.hpp"

namespace vibro_impact::comparison {

namespace {

// Records of an event what is compared, as the other methods do.
struct ComparedEventRecorder : Recorder {
  std::vector<Event> events = {};

  void event(const Event &event, const Moment &) override {
    events.push_back(event_at(event.time, event.mass, event.kind, event.velocity_before));
  }
};

Result run_with(const Problem &problem, const RunOptions &options) {
  Result result;
  ComparedEventRecorder recorder;
  const Outcome outcome =
      Simulation(problem.scene, problem.start, options).advance(problem.until, recorder);
  result.events = std::move(recorder.events);
  result.failure = outcome.reason;
  result.impacts = outcome.counters.impacts;
  return result;
}

}  // namespace

std::vector<Method> this_library() {
  constexpr double rounding = std::numeric_limits<double>::epsilon();
  return {{"this library",
           {1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13},
           [](const Problem &problem, double tolerance) {
             RunOptions options;  // the tolerance of a chatter limit is ten times that of a flight
             options.chatter_tolerance = tolerance;
             options.flight_tolerance = std::max(0.1 * tolerance, options.flight_tolerance);
             return run_with(problem, options);
           },
           true},
          // Every impact is made until the rest of a chatter lies below rounding. There is nothing
          // to sweep, because flow and roots are exact to rounding.
          {"this library (every impact)", {rounding}, [](const Problem &problem, double) {
             return run_with(problem, {.limit_below_speed = 0.0});
           }}};
}

}  // namespace vibro_impact::comparison
