#include "vibro_impact/simulate.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "simulation/chain/forces.hpp"
#include "simulation/chain/require.hpp"
#include "start.hpp"

namespace vibro_impact {

namespace {

void require_finite(const std::vector<double> &values, std::size_t size, const char *what) {
  require(values.size() == size, "start: ", values.size(), " values of the ", what, ", not ", size);
  for (const double value : values)
    require(std::isfinite(value), "start: ", what, " = ", value, ": must be finite");
}

// What both kinds of start have: an instant, and masses held at stops that exist.
void check_common(const Scene &scene, const Instant &instant, const Held &held) {
  const Clock clock(scene.omega);
  require(instant.cycle >= 0 && instant.phase >= 0.0 && instant.phase < clock.period,
          "start: phase = ", instant.phase, " in period ", instant.cycle, ": must lie in [0, ",
          clock.period, ")");
  require(held.size() == scene.mass.size(), "start: the contact mode of ", held.size(),
          " masses given, the chain has ", scene.mass.size());
  for (std::size_t i = 0; i < held.size(); ++i)
    require(held[i] == 0 || std::any_of(scene.stops.begin(), scene.stops.end(),
                                        [&](const Stop &stop) {
                                          return static_cast<std::size_t>(stop.mass - 1) == i &&
                                                 held[i] == static_cast<signed char>(stop.side);
                                        }),
            "start: mass ", i + 1, " held as ", static_cast<int>(held[i]),
            ": it has no such stop (0 free, 1 upper, -1 lower)");
}

void check_start(const Scene &scene, const MotionState &start) {
  require_finite(start.displacement, scene.mass.size(), "displacement");
  require_finite(start.velocity, scene.mass.size(), "velocity");
  check_common(scene, start.instant, start.held);
  for (const Stop &stop : scene.stops) {
    const auto i = static_cast<std::size_t>(stop.mass - 1);
    const double x = start.displacement[i], v = start.velocity[i];
    require(sign(stop.side) * (stop.position - x) >= 0.0, "start: mass ", stop.mass, " at ", x,
            ", beyond its ", name(stop.side), " stop at ", stop.position);
    if (start.held[i] == static_cast<signed char>(stop.side))
      require(x == stop.position && v == 0.0, "start: mass ", stop.mass, " is held at its ",
              name(stop.side), " stop at ", stop.position, ", and stands at ", x, " with velocity ",
              v);
  }
}

void check_state(const Scene &scene, const RunState &state) {
  require_finite(state.value, state.value.size(), "modal coordinate");
  require_finite(state.slope, state.value.size(), "modal velocity");
  check_common(scene, state.instant, state.held);
  require(state.stops.size() == scene.stops.size(), "start: ", state.stops.size(),
          " stops given, the scene has ", scene.stops.size());
  for (const auto &stop : state.stops)
    require(stop.gap >= 0.0 && std::isfinite(stop.gap) && std::isfinite(stop.speed) &&
                stop.zeros >= 0 && std::isfinite(stop.leading),
            "start: gap = ", stop.gap, ", speed = ", stop.speed, ", ", stop.zeros,
            " zeros at a stop: not those of a run");
  require(state.next_flight >= 0.0 && state.told >= 0 && state.impacts_this_period >= 0,
          "start: next flight ", state.next_flight, ", ", state.told,
          " events told: not those of a run");
}

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

Outcome run(const Scene &scene, const Start &start, const Instant &from, double until,
            const RunOptions &options, std::span<const RecorderRef> recorders) {
  const Clock clock(scene.omega);
  const double begins = time_of(from, clock);
  check_options(options);
  require(std::isfinite(until), "until = ", until, ": must be finite");
  require(until >= begins || !(instant_at(until, clock) < from), "until = ", until,
          ": lies before the start at ", begins);
  // The whole periods are counted, and the phase kept exact.
  require(!(until * scene.omega > 0x1p53), "until = ", until,
          ": more forcing periods than double precision can count");
  for (const RecorderRef &recorder : recorders) {
    if (recorder.check != nullptr) recorder.check(recorder.recorder, scene);
    if (recorder.sample == nullptr) continue;
    const double first = recorder.next_time(recorder.recorder);
    require(!(first < begins), "sample at t = ", first, ": the run begins at ", begins);
  }
  // Two masses under forcing, the paper's case, get lanes of fixed size; the code is the same. They
  // have no room for a strongly damped mode split in two.
  if (scene.forced() && scene.masses() == 2 &&
      !strongly_damped(scene.beta, largest_eigenvalue_bound(scene)))
    return run_lanes<4>(scene, start, until, options, recorders);
  return run_lanes<any_lanes>(scene, start, until, options, recorders);
}

}  // namespace

MotionState start_of(const Scene &scene) {
  const std::size_t n = scene.mass.size();
  const auto or_zero = [n](const std::vector<double> &values) {
    return values.empty() ? std::vector<double>(n, 0.0) : values;
  };
  return {Instant{}, or_zero(scene.displacement), or_zero(scene.velocity), Held(n, 0)};
}

const Outcome &require_complete(const Outcome &outcome) {
  if (outcome.ending == Ending::given_up) throw std::runtime_error(outcome.reason);
  return outcome;
}

Outcome simulate_seen(const Scene &scene, const MotionState &start, double until,
                      const RunOptions &options, std::span<const RecorderRef> recorders) {
  check(scene);
  check_start(scene, start);
  return run(scene, {&start, nullptr}, start.instant, until, options, recorders);
}

Outcome resume_seen(const Scene &scene, const RunState &state, double until,
                    const RunOptions &options, std::span<const RecorderRef> recorders) {
  check(scene);
  check_state(scene, state);
  return run(scene, {nullptr, &state}, state.instant, until, options, recorders);
}

}  // namespace vibro_impact
