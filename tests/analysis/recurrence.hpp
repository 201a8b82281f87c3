// The period of a settled motion by comparing whole states: what `settle` is held against.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "vibro_impact/analysis/periodic_orbit.hpp"

namespace vibro_impact {

struct Recurrence {
  int periods = 0;        // smallest n <= 8 with the state after n periods the same; 0: none
  double distance = 0.0;  // largest component of their difference (0 periods: the least)
};

// States closer than 1e-8 count as the same.
inline Recurrence recurrence(const Scene &scene, const MotionState &state) {
  const std::vector<double> from = coordinates(state);
  Recurrence least{0, std::numeric_limits<double>::infinity()};
  for (int n = 1; n <= 8; ++n) {
    const MotionState end = stroboscopic_map(scene, state, n);
    const std::vector<double> to = coordinates(end);
    double distance = 0.0;
    for (std::size_t i = 0; i < from.size(); ++i)
      distance = std::max(distance, std::abs(to[i] - from[i]));
    if (end.held == state.held && distance <= 1e-8) return {n, distance};
    least.distance = std::min(least.distance, distance);
  }
  return least;
}

}  // namespace vibro_impact
