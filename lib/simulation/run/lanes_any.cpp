#include "lanes.hpp"

template vibro_impact::Outcome vibro_impact::run_lanes<Eigen::Dynamic>(
    const Scene &, const MotionState *, const RunState *, double, const RunOptions &,
    std::span<const RecorderRef>);
