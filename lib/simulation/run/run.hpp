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

  Problem(std::shared_ptr<const Scene> scene_of_run, const RunOptions &options_of_run);
};

// Hints of the latest step and its events for the next step.
struct StepHint {
  double flight_time = infinity;  // expected until the next impact of a mass that was just hit
  long long quiet_steps = 0;      // steps since the latest event
  // `longest_in_flights` times a mean of the latest flights that ended at an event, of which each
  // counts half as much as the next one. Without an event in the latest step, only the mode bounds
  // the length.
  double step_between_events = infinity;
};

// An impact of an instant, and the speed at which the mass came.
struct Hit {
  Contact contact;
  Real closing = 0.0;
  double flight_time = infinity;  // expected after it, to leading order
};

// Storage that is reused from event to event. No value passes from one event to the next.
struct Scratch {
  StepSearch step;
  std::vector<Start> starts;  // one for each contact of the mode
  std::vector<Near> near;     // likewise
  RestDecision rest;
  std::vector<RestingMass> resting;
  std::vector<Hit> hits;
  Held held;
  Event event;
  Motion motion;  // at a sample or an end
};

// The limit of a chatter, found at a node. Where an end, a sample or an impact that is asked for
// lies before it, the run goes on from impact to impact until nothing is left to be reported. Then
// it is put to the limit, as if it still stood at the node: what was reported changes no motion.
struct ChatterLimit {
  bool is_ahead = false;  // the run has gone on
  Motion motion;          // at the limit
  std::size_t stop = 0;
  ImpactSum unreported;          // of the impacts between the node and the limit
  double slowest = infinity;     // of the impacts that are reported
  std::vector<StopState> stops;  // as at the node,
  Counters counters;             // and the work of this call up to there, if the run has gone on
};

// The progress of one call of `advance`.
struct Progress {
  Instant end;
  std::optional<Ending> ending = {};  // when the call is over
  std::string reason = {};
  // The time of the next sample. It changes when a recorder has been called.
  double next_sample = infinity;
  MotionState last = {};  // the state at the end; empty before
};

struct Run {
  Problem problem;
  std::optional<MotionState> start;  // the initial state, until the run begins
  ContactModes modes = {};
  Motion motion = {};
  std::vector<StopState> stops = {};  // one for each stop of the scene
  Chatter chatter = {};
  ChatterLimit limit = {};
  LongFlight long_flight = {};
  StepHint hint = {};
  Counters counters = {};
  Progress progress = {};
  Scratch scratch = {};

  const Scene &scene() const {
    return *problem.scene;
  }
  const Chain &chain() const {
    return *problem.chain;
  }
  // The time of its motion, counted from t = 0.
  double time() const {
    return time_of(motion.now.rounded(), chain().clock);
  }
  // The time from its motion to an instant.
  Real time_until(const Instant &instant) const {
    return elapsed(motion.now, TwofoldInstant(instant), chain().clock);
  }
};

// Runs on to `end`, or until a recorder is done or the run is given up, and sets progress.last to
// the state there. The motion of the run stays at the start of the flight that contains the end:
// hence the flights do not depend on where a call ends, but for those before the limit of a
// chatter.
void advance(Run &run, const Instant &end, Recorders recorders);

}  // namespace vibro_impact::detail
