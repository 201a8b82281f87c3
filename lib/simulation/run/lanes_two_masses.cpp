#include "lanes.hpp"

template vibro_impact::Outcome vibro_impact::run_lanes<4>(const Scene &, const MotionState *,
                                                          const RunState *, double,
                                                          const RunOptions &,
                                                          std::span<const RecorderRef>);
