// A run: everything that it carries from event to event. The event loop alone changes it.
#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "simulation/chain/mode_change.hpp"
#include "simulation/chatter/limit.hpp"
#include "simulation/stops/rest.hpp"
#include "vibro_impact/simulate.hpp"

namespace vibro_impact::detail {

using Recorders = std::span<const RecorderRef>;

// What a run is of.
struct Problem {
  std::shared_ptr<const Scene> scene;
  RunOptions options;
  Clock clock;
  double rate_bound;
  bool forced;
  OrderTable orders;

  Problem(std::shared_ptr<const Scene> of, const RunOptions &with);
};

// What the flight before says of the next step.
struct StepHint {
  double flight = std::numeric_limits<double>::infinity();  // expected: of a mass that was just hit
  // Whether a long flight without events may be ahead: no contact was within reach in the latest
  // step, or the rigid-body mode drifted through a step without an event.
  bool quiet = true;
  bool postponed = false;  // a decision waits for the next instant of the clock
};

// Impacts in one window of time, of which a run may have so many before it is given up.
struct ImpactBudget {
  double window;
  Instant since = {};
  long long impacts = 0;
};

// Storage that is reused from event to event. It carries nothing from one to the next.
struct Scratch {
  Flight flight;
  LimitState limit;
  RestDecision rest;
  PerCoordinate change, speed;
  ChainMotion chain;
  Motion sampled;
  std::vector<StopState> sampled_stops;
  std::vector<std::size_t> hits, roots;  // contacts of the event at hand
  std::vector<double> flights, jumps;    // after the impacts at hand: expected, and of gap speeds
  MotionState state;
  Event event;
};

// How a call of `advance` stands.
struct Progress {
  Instant end;
  bool over = false;
  Ending ending = Ending::reached;
  std::string reason = {};
  // Inside a chatter that is carried to its limit, impacts are resolved for samples and ends alone:
  // nothing is reported but samples, and no limit is taken.
  bool inside_chatter = false;
  MotionState last = {};  // the state at the end
};

struct Run {
  Problem problem;
  std::optional<MotionState> start;  // of a run that has not begun
  ContactModes modes = {};
  Motion motion = {};
  std::vector<StopState> stops = {};  // one for each stop of the scene
  Chatter chatter = {};
  StepHint hint = {};
  ImpactBudget budget;
  Counters counters = {};
  Progress progress = {};
  Scratch scratch = {};

  const Scene &scene() const {
    return *problem.scene;
  }
};

// Runs on to `end`, or until a recorder is done or the run is given up. The run then stands at the
// last step before, from which the motion goes on to the state at the end: the steps do not depend
// on where a call ends.
void advance(Run &run, const Instant &end, Recorders recorders);

}  // namespace vibro_impact::detail
