// A run: everything that it carries from event to event.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "simulation/chatter/reach.hpp"
#include "simulation/flight/first_event.hpp"
#include "simulation/modal/long_flight.hpp"
#include "simulation/stops/rest.hpp"
#include "vibro_impact/simulate.hpp"

namespace vibro_impact::detail {

using Recorders = std::span<Recorder *const>;

// The scene and the options of a run, with the constants that follow from them.
struct Problem {
  std::shared_ptr<const Scene> scene;
  std::shared_ptr<const Chain> chain;
  RunOptions options;
  Clock clock;
  OrderTable orders;

  Problem(std::shared_ptr<const Scene> scene_of_run, const RunOptions &options_of_run);
};

// Hints of the latest step and its events for the next step.
struct StepHint {
  double flight_time = infinity;  // expected until the next impact of a mass that was just hit
  long long quiet_steps = 0;      // steps since the latest event
  // `longest_in_flights` times a mean of the latest flights, of which each counts half as much as
  // the next one. Without an event in the latest step, only the mode bounds the length.
  double step_between_events = infinity;
  // A decision about a stop is postponed: the next step ends at most two roundings of the clock
  // later, or `least_delay` after t = 0.
  bool postponed = false;
};

// An impact of an instant, and the speed at which the mass came.
struct Hit {
  Contact contact;
  Real closing = 0.0;
  double flight_time = infinity;  // expected after it, to leading order
};

// Storage that is reused from event to event. No value passes from one event to the next.
struct Scratch {
  Flight flight;
  std::vector<Start> starts;  // one for each contact of the mode
  std::vector<Near> near;     // likewise
  Motion motion;              // at the limit of a chatter
  RestDecision rest;
  std::vector<RestingMass> resting;
  std::vector<Hit> hits;
  Held held;
  Event event;
};

// The part of a run that a call of `advance` resolves. A call inside a chatter resolves the impacts
// between the latest node and the limit, which it does not take. With `end_in_chatter` it goes to
// its end. With `inside_chatter` it ends as soon as no sample and no impact is left to be reported.
enum class Extent { whole, end_in_chatter, inside_chatter };

// The progress of one call of `advance`.
struct Progress {
  Instant end;
  bool over = false;
  Ending ending = Ending::reached;
  std::string reason = {};
  Extent extent = Extent::whole;
  // The time of the next sample. It changes when a recorder has been called.
  double next_sample = infinity;
  // A call inside a chatter has the speed down to which impacts are reported, whether such impacts
  // are still to come, and the number of impacts so far.
  double slowest = infinity;
  bool lists = false;
  long long impacts = 0;
  MotionState last = {};  // the state at the end; empty before
};

struct Run {
  Problem problem;
  std::optional<MotionState> start;  // the initial state, until the run begins
  ContactModes modes = {};
  Motion motion = {};
  std::vector<StopState> stops = {};  // one for each stop of the scene
  Chatter chatter = {};
  LongFlight long_flight = {};
  StepHint hint = {};
  // The latest call ended inside a chatter, whose impacts after the latest node are not yet taken.
  bool ended_inside_chatter = false;
  // The number of impacts between this node and the end of the latest call. They lie in the past:
  // `reported` and `unreported` of the stops contain them.
  long long past_impacts = 0;
  Counters counters = {};
  Progress progress = {};
  Scratch scratch = {};

  const Scene &scene() const {
    return *problem.scene;
  }
  const Chain &chain() const {
    return *problem.chain;
  }
};

// Runs on to `end`, or until a recorder is done or the run is given up, and sets progress.last to
// the state there. The motion of the run stays at the start of the flight that contains the end:
// hence the flights do not depend on where a call ends.
void advance(Run &run, const Instant &end, Recorders recorders, Extent extent = Extent::whole,
             double slowest = infinity);

}  // namespace vibro_impact::detail
