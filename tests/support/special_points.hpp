// The special points of a branch, which tests compare with known ones and with each other.
#pragma once

#include <vector>

#include "vibro_impact/analysis/follow_orbit.hpp"

namespace vibro_impact::testing {

// All points but the orbits between them. A coincidence is special to no orbit.
inline std::vector<OrbitPoint> special_points_of(std::vector<OrbitPoint> branch) {
  std::erase_if(branch, [](const OrbitPoint &point) {
    return point.kind == BranchPoint::orbit || point.kind == BranchPoint::coincidence;
  });
  return branch;
}

}  // namespace vibro_impact::testing
