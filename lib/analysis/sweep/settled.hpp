// A settled motion with the record of its orbit.
#pragma once

#include "analysis/orbits/newton.hpp"
#include "vibro_impact/analysis/settle.hpp"

namespace vibro_impact {

struct Settled {
  SettledMotion motion;
  NewtonOrbit orbit = {};  // at the section of `motion.orbit`
};

// Throws what `settle` throws before it begins.
void check_settling(const Scene &scene, const MotionState &start, const SettleOptions &options);
// `settle` without these checks.
Settled settled(const Scene &scene, const MotionState &start, const SettleOptions &options);

}  // namespace vibro_impact
