// The extreme and the degenerate cases: the scenes of reference/scenes/extreme_cases.hpp and
// reference/scenes/degenerate_cases.hpp (numbers only), simulated by the generator.
#pragma once

#include "event_driven.hpp"
#include "reference/scenes/degenerate_cases.hpp"
#include "reference/scenes/extreme_cases.hpp"

#include <string>
#include <vector>

namespace vibro_impact_reference {

inline Scene in_digits(const vibro_impact::extremes::Case &extreme) {
  return in_digits(extreme.name, extreme.scene, extreme.until);
}

/// The thresholds of a case: its slowest impact, and bounces without a pressing force 1e-4 below
/// it.
inline Resolution resolution_of(const vibro_impact::extremes::Case &extreme) {
  Resolution resolution;
  resolution.speed_floor = Real(extreme.slowest_impact);
  resolution.hopeless_speed = resolution.speed_floor * Real("1e-4");
  return resolution;
}

/// The cases whose truth is the generator's.
inline std::vector<vibro_impact::extremes::Case> cases_in_digits() {
  std::vector<vibro_impact::extremes::Case> selected;
  for (const auto &extreme : vibro_impact::extremes::all_cases()) {
    if (extreme.truth == vibro_impact::extremes::Truth::digits) selected.push_back(extreme);
  }
  return selected;
}

}  // namespace vibro_impact_reference
