// The motion of two masses by a procedure with fixed steps.
#pragma once

#include "procedures.hpp"

namespace vibro_impact::figures {

// `follow` for a procedure with a positive step.
FollowedMotion follow_in_steps(const Scene &scene, MotionState state, double until,
                               const Procedure &procedure);

}  // namespace vibro_impact::figures
