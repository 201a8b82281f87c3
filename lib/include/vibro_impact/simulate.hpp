// A run: from a scene and a start to an outcome, telling recorders what happens on the way.
#pragma once

#include <array>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "counters.hpp"
#include "record.hpp"
#include "scene.hpp"

namespace vibro_impact {

struct RunOptions {
  // Chatter is carried to its limit only from impacts slower than this: every faster one is
  // resolved and recorded. 0 resolves chatter until what is left of it lies below rounding.
  double resolve_chatter = std::numeric_limits<double>::infinity();
  // Largest estimated relative error at which a chatter limit is accepted, in (0, 1).
  double chatter_tolerance = 1e-13;
  // Largest remainder of the expansion of a flight, relative to its second-order term, in (0, 1);
  // the order follows from it. The default lies below rounding.
  double flight_tolerance = 0x1p-56;
  // More impacts than this in one forcing period (of the fastest mode where there is no forcing)
  // end the run: it is given up.
  long long max_impacts_per_period = 1'000'000;
};

// Where a run stands: what `resume` needs to go on, bit for bit, as if the run had never ended, also
// inside a chatter. It may lie a little before the end of the run, at its last step. It belongs to
// the scene of that run; what its numbers mean is the simulation's own affair.
struct RunState {
  std::vector<double> numbers = {};  // empty: there is no run to go on from, which `resume` refuses
};

// Why a run ended: it reached its time, a recorder was done, or it was given up.
enum class Ending { reached, stopped, given_up };

struct Outcome {
  MotionState state;  // at the end
  double time = 0.0;
  Ending ending = Ending::reached;
  std::string reason = {};  // one line: why the run was given up
  Counters counters;
  RunState resume;
};

// Throws std::runtime_error with the reason when the run was given up.
const Outcome &require_complete(const Outcome &outcome);

// Runs `scene` to time `until` (non-dimensional, counted from t = 0) and tells the recorders what
// they ask for. Throws std::invalid_argument, with one line that names the value and the rule, for
// a scene that `check` rejects, a start that does not fit it, options out of range, a recorder that
// rejects the scene, and a time that is not finite or lies before the start.
Outcome simulate_seen(const Scene &scene, const MotionState &start, double until,
                      const RunOptions &options, std::span<const RecorderRef> recorders);

// The same from where another run of the same scene stood: event by event, bit for bit, what that
// run would have gone on with. Throws std::invalid_argument for no state, and for that of a run of
// another scene as far as its numbers show it.
Outcome resume_seen(const Scene &scene, const RunState &state, double until,
                    const RunOptions &options, std::span<const RecorderRef> recorders);

template <class... Recorders>
Outcome simulate_from(const Scene &scene, const MotionState &start, double until,
                      const RunOptions &options = {}, Recorders &...recorders) {
  const std::array<RecorderRef, sizeof...(Recorders)> seen{recorder_ref(recorders)...};
  return simulate_seen(scene, start, until, options, seen);
}

// From the scene's own initial state at t = 0.
template <class... Recorders>
Outcome simulate(const Scene &scene, double until, const RunOptions &options = {},
                 Recorders &...recorders) {
  return simulate_from(scene, start_of(scene), until, options, recorders...);
}

template <class... Recorders>
Outcome resume(const Scene &scene, const RunState &state, double until,
               const RunOptions &options = {}, Recorders &...recorders) {
  const std::array<RecorderRef, sizeof...(Recorders)> seen{recorder_ref(recorders)...};
  return resume_seen(scene, state, until, options, seen);
}

}  // namespace vibro_impact
