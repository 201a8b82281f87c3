// The pipeline: chain -> contact mode -> flow -> first event -> impact / chatter limit / sticking
// -> record. simulate.cpp is the loop over these steps, run.hpp what it carries from event to
// event.
#pragma once

#include <array>
#include <limits>
#include <span>

#include "counters.hpp"
#include "expansion.hpp"
#include "recorder_ref.hpp"
#include "scene.hpp"

namespace vibro_impact {

struct RunOptions {
  // Chatter is carried to its limit only from impacts slower than this: every faster one is
  // resolved and recorded. 0 resolves chatter until what is left of it lies below rounding.
  double resolve_chatter = std::numeric_limits<double>::infinity();
  // Largest estimated relative error at which a chatter limit is accepted.
  double chatter_tolerance = 1e-13;
  // Largest remainder of the expansion of a flight, relative to its second-order term; the order
  // follows from it. By default below rounding.
  double flight_tolerance = flight_rounding;
  // More impacts than this in one forcing period end the run with an error carrying the state.
  long long max_impacts_per_period = 1'000'000;
};

struct Outcome {
  MotionState state;  // at the end
  double time = 0.0;
  Counters counters;
};

// The initial state of a scene, at t = 0 with no mass held yet.
inline MotionState start_of(const Scene &scene) {
  const auto n = static_cast<Eigen::Index>(scene.mass.size());
  const auto vector = [n](const std::vector<double> &values) -> Eigen::VectorXd {
    if (values.empty()) return Eigen::VectorXd::Zero(n);
    return Eigen::Map<const Eigen::VectorXd>(values.data(), n);
  };
  return {Instant{}, vector(scene.displacement), vector(scene.velocity),
          Held(scene.mass.size(), 0)};
}

// Runs `scene` from `start` to time `until` (non-dimensional) and tells `recorders` what they ask
// for. Throws std::invalid_argument for a scene that `check` rejects, std::runtime_error (with the
// state) when the impacts of one period exceed the stated limit.
Outcome simulate_seen(const Scene &scene, const MotionState &start, double until,
                      const RunOptions &options, std::span<const RecorderRef> recorders);

template <class... Recorders>
Outcome simulate_from(const Scene &scene, const MotionState &start, double until,
                      const RunOptions &options, Recorders &...recorders) {
  const std::array<RecorderRef, sizeof...(Recorders)> seen{recorder_ref(recorders)...};
  return simulate_seen(scene, start, until, options, seen);
}

// The same from the scene's own initial state at t = 0.
template <class... Recorders>
Outcome simulate(const Scene &scene, double until, const RunOptions &options,
                 Recorders &...recorders) {
  check(scene);
  return simulate_from(scene, start_of(scene), until, options, recorders...);
}

}  // namespace vibro_impact
