#include "vibro_impact/simulate.hpp"

#include <cmath>
#include <stdexcept>

#include "run_state.hpp"
#include "simulation/chain/forces.hpp"
#include "simulation/chain/require.hpp"

namespace vibro_impact {

namespace {

void check_options(const RunOptions &options) {
  for (const auto &[name, tolerance] :
       {std::pair{"chatter", options.chatter_tolerance}, {"flight", options.flight_tolerance}})
    require(tolerance > 0.0 && tolerance < 1.0, name, "_tolerance = ", tolerance,
            ": must lie between 0 and 1");
  require(options.resolve_chatter >= 0.0, "resolve_chatter = ", options.resolve_chatter,
          ": must be non-negative");
  require(options.max_impacts_per_period > 0,
          "max_impacts_per_period = ", options.max_impacts_per_period, ": must be positive");
}

Outcome run(const Scene &scene, const MotionState *motion, const RunState *state,
            const Instant &from, double until, const RunOptions &options,
            std::span<const RecorderRef> recorders) {
  const Clock clock(scene.omega);
  const double begins = time_of(from, clock);
  check_options(options);
  require(std::isfinite(until), "until = ", until, ": must be finite");
  require(until >= begins || !(instant_at(until, clock) < from), "until = ", until,
          ": lies before the start at ", begins);
  for (const RecorderRef &recorder : recorders) {
    if (recorder.check) recorder.check(scene);
    if (!recorder.sample) continue;
    require(recorder.next_time != nullptr, "a recorder takes samples and asks for no time");
    const double first = recorder.next_time();
    require(first >= begins, "sample at t = ", first, ": the run begins at ", begins);
  }
  // Two masses under forcing, the paper's case, get lanes of fixed size; the code is the same. They
  // have no room for a strongly damped mode split in two.
  if (scene.forced() && scene.masses() == 2 &&
      !strongly_damped(scene.beta, largest_eigenvalue_bound(scene)))
    return run_lanes<4>(scene, motion, state, until, options, recorders);
  return run_lanes<Eigen::Dynamic>(scene, motion, state, until, options, recorders);
}

}  // namespace

const Outcome &require_complete(const Outcome &outcome) {
  if (outcome.ending == Ending::given_up) throw std::runtime_error(outcome.reason);
  return outcome;
}

Outcome simulate_seen(const Scene &scene, const MotionState &start, double until,
                      const RunOptions &options, std::span<const RecorderRef> recorders) {
  check(scene);
  check(scene, start);
  return run(scene, &start, nullptr, start.instant, until, options, recorders);
}

Outcome resume_seen(const Scene &scene, const RunState &state, double until,
                    const RunOptions &options, std::span<const RecorderRef> recorders) {
  check(scene);
  return run(scene, nullptr, &state, instant_of(state), until, options, recorders);
}

}  // namespace vibro_impact
