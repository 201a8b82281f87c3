// A run: everything that it carries from event to event. Only event_loop.cpp and
// events_at_an_instant.cpp change it.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "simulation/chain/contact_modes.hpp"
#include "simulation/chain/mode_change.hpp"
#include "simulation/chatter/limit.hpp"
#include "simulation/flight/first_event.hpp"
#include "simulation/stops/rest.hpp"
#include "vibro_impact/simulate.hpp"

namespace vibro_impact::detail {

using Recorders = std::span<Recorder *const>;

// The scene and the options of a run, with the constants that follow from them.
struct Problem {
  std::shared_ptr<const Scene> scene;
  RunOptions options;
  Clock clock;
  double rate_bound;     // of the scene: see rate_bound in forces.hpp
  double forcing_bound;  // the sum of the moduli of the forcing
  bool forced;
  OrderTable orders;

  Problem(std::shared_ptr<const Scene> scene_of_run, const RunOptions &options_of_run);
};

// The consequences of the latest step and its events for the choice of the next step. A step resets
// the hint in `run_step`; then `hold_or_release` sets `postponed`, and `follow_chatter` sets
// `flight_time`. A chatter limit resets the hint too.
struct StepHint {
  // Expected time to the next impact of a mass that was just hit.
  double flight_time = infinity;
  // A long flight without events may follow: no contact was within reach in the latest step, or the
  // rigid-body mode drifted through a step without an event.
  bool quiet = true;
  // A decision about a stop is postponed: the next step ends one rounding of the clock later.
  bool postponed = false;
};

// Storage that is reused from event to event. No value passes from one event to the next.
struct Scratch {
  Flight flight;
  LimitState limit;
  RestDecision rest;
  ChainMotion chain;
  std::vector<std::optional<Gap>> gaps;  // one for each stop, before a mode change
  Motion sampled;                        // the motion at a sample or at the end of a call,
  std::vector<StopState> sampled_stops;  // with the stops
  Placement placed;                      // gaps in the new mode
  // Storage of ContactsOfInstant.
  std::vector<std::size_t> hits, roots;
  // For each hit the expected time of the flight after it, and the jump of the gap speed.
  std::vector<double> flight_times, jumps;
  MotionState state;
  Event event;
};

// The progress of one call of `advance`.
struct Progress {
  Instant begin, end;  // no event before the begin is reported
  bool over = false;
  Ending ending = Ending::reached;
  std::string reason = {};
  // True of the copy of a run that resolves the impacts of a chatter before its limit, because a
  // sample or the end lies there. The copy reports samples only and takes no limit.
  bool inside_chatter = false;
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
  StepHint hint = {};
  Counters counters = {};
  Progress progress = {};
  Scratch scratch = {};

  const Scene &scene() const {
    return *problem.scene;
  }
};

// Runs on to `end`, or until a recorder is done or the run is given up, and sets progress.last to
// the state there. The motion of the run stays at the start of the step that contains the end:
// hence the steps do not depend on where a call ends.
void advance(Run &run, const Instant &end, Recorders recorders);

}  // namespace vibro_impact::detail
