// The special points of a branch, which tests compare with known ones and with each other. Scenes
// stand in the words of a scene file.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "vibro_impact/analysis/analysis.hpp"
#include "vibro_impact/scene_text.hpp"

namespace vibro_impact::testing {

// All points but the orbits between them. A coincidence is special to no orbit.
inline std::vector<OrbitPoint> special_points_of(std::vector<OrbitPoint> branch) {
  std::erase_if(branch, [](const OrbitPoint &point) {
    return point.kind == BranchPoint::orbit || point.kind == BranchPoint::coincidence;
  });
  return branch;
}

// A scene in the words of a scene file: `masses = 1; amplitude = 0.1; ...`. What is not given is as
// in the paper.
inline Scene scene_of(std::string_view text) {
  Scene scene;
  scene.beta = 0.1;
  scene.restitution = 0.7;
  for (const std::string_view field : words::parts_of(text, ';')) {
    const auto trimmed = [](std::string_view word) {
      const std::size_t first = word.find_first_not_of(' ');
      return word.substr(first, word.find_last_not_of(' ') + 1 - first);
    };
    const auto parts = words::parts_of(field, '=');
    if (!set_field(scene, trimmed(parts[0]), trimmed(parts[1])))
      throw std::invalid_argument(std::string(field) + ": is no field");
  }
  return scene;
}

struct Special {
  BranchPoint kind;
  double parameter;
  double within = 1e-14;  // of the parameter
};

// The branch from its end towards range.from to its end towards range.to.
inline std::vector<OrbitPoint> branch_of(const Scene &scene, const Axis &range, int period = 0,
                                         int longest = 2000) {
  const OrbitRecord settled = record_of(scene, {.settle = {.longest = longest}});
  const MotionState near = at_quiet_phase(scene, settled.state);
  const int periods = period > 0 ? period : std::max(settled.period, 1);
  Axis reversed = range;
  std::swap(reversed.from, reversed.to);
  const auto up = follow_orbit(scene, near, range, {.periods = periods});
  auto branch = follow_orbit(scene, near, reversed, {.periods = periods});
  if (up.back().kind == BranchPoint::closed) return up;
  std::ranges::reverse(branch);
  branch.insert(branch.end(), up.begin() + 1, up.end());
  return branch;
}

// Orbits that were found by other means have these special points, and no others, in this order.
inline void expect_special_points(const std::string &scene, const Axis &range,
                                  const std::vector<Special> &expected, int period = 0,
                                  int longest = 2000) {
  SCOPED_TRACE(scene);
  for (const std::size_t factor : {1u, 2u}) {
    Axis axis = range;
    axis.count = factor * (range.count - 1) + 1;
    const auto special = special_points_of(branch_of(scene_of(scene), axis, period, longest));
    ASSERT_EQ(special.size(), expected.size()) << factor;
    for (std::size_t k = 0; k < expected.size(); ++k) {
      EXPECT_STREQ(name(special[k].kind), name(expected[k].kind)) << k;
      const double off = std::abs(special[k].parameter - expected[k].parameter);
      EXPECT_LE(off, expected[k].within) << k;
      EXPECT_LE(off, std::max(special[k].error, 1e-14)) << k;
      EXPECT_LT(special[k].error, 10.0 * expected[k].within) << k;
    }
  }
}

}  // namespace vibro_impact::testing
