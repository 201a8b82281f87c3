// The functions of settle.hpp and lyapunov.hpp, of a simulation whose scene has been checked and
// whose options are those of the runs.
#pragma once

#include "vibro_impact/analysis/lyapunov.hpp"
#include "vibro_impact/analysis/settle.hpp"

namespace vibro_impact {

std::vector<Event> without_chatters(const Scene &scene, const std::vector<Event> &events,
                                    bool all_before_sticks = false);

// True of two events of one kind at one stop.
inline bool same_kind(const Event &a, const Event &b) {
  return a.kind == b.kind && a.stop == b.stop;
}

// The simulation has not run yet.
SettledMotion settle(Simulation simulation, const MotionState &start, const SettleOptions &options);

Growth mean_growth(Simulation &simulation, const MotionState &start, const GrowthOptions &options);

}  // namespace vibro_impact
