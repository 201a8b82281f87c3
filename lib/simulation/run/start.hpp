// What a run starts from, and the run for lanes of one size.
#pragma once

#include <span>

#include "vibro_impact/simulate.hpp"

namespace vibro_impact {

// What a run starts from: the motion at the start, or where another run stood.
struct Start {
  const MotionState *motion = nullptr;
  const RunState *state = nullptr;
};

constexpr int any_lanes = -1;  // Eigen::Dynamic

// True for two masses under forcing, the paper's case, which get lanes of fixed size; the code is
// the same. They have no room for a strongly damped mode split in two.
bool has_four_lanes(const Scene &scene);

// Runs a scene, checked, on D lanes: N + 2 for N masses under forcing, or any number.
template <int D>
Outcome run_lanes(const Scene &scene, const Start &start, double until, const RunOptions &options,
                  std::span<const RecorderRef> recorders);

}  // namespace vibro_impact
