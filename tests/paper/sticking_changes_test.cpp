// The list of frequencies at which the sticking phases of the motion from rest change is complete:
// between neighbours of the list the number of phases stays the same, and at each it changes.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "figures/runs.hpp"
#include "reference/numbers/checked_number.hpp"
#include "reference/numbers/quantities.hpp"
#include "vibro_impact/analysis/analysis.hpp"

namespace {

using namespace vibro_impact;

// The frequencies of a mass from 0.25 to 0.5, as the table of references has them, with both ends.
std::vector<double> frequencies(int mass) {
  std::vector<double> known{0.25, 0.5};
  for (const auto &number : numbers::checked_numbers(REFERENCE_DIR))
    if (number.quantity == "changing_frequency" && number.arguments.mass("mass") == mass &&
        numbers::motion_in(number.arguments) != numbers::Motion::followed)
      known.push_back(number.value);
  std::sort(known.begin(), known.end());
  return known;
}

// 1e-10 is the tolerance of these key numbers. Each interval is also tried at nine frequencies
// inside.
TEST(StickingChanges, AreAllOfThoseBetween025And05) {
  std::size_t changes = 0;
  for (const int mass : {1, 2}) {
    const std::vector<double> known = frequencies(mass);
    changes += known.size() - 2;
    int before = -1;
    for (std::size_t i = 1; i < known.size(); ++i) {
      const double from = known[i - 1] + 1e-10, to = known[i] - 1e-10;
      const auto phases = [mass](double omega) {
        return figures::settled_sticking_phases(paper::figure3(omega), mass);
      };
      const int here = phases(from);
      EXPECT_NE(here, before) << "mass " << mass << " at " << known[i - 1];
      for (int k = 1; k <= 10; ++k) {
        const double omega = from + 0.1 * k * (to - from);
        EXPECT_EQ(phases(omega), here) << "mass " << mass << " at " << omega;
      }
      before = here;
    }
  }
  EXPECT_EQ(changes, 13u);
}

// At the jump the motion from rest changes, and both motions exist on both sides. Followed upwards,
// the motion in which mass 1 sticks goes on; followed downwards, so does the other one.
TEST(StickingChanges, AtTheJumpBothMotionsAreStableOnBothSides) {
  const auto settled_at = [](double omega) {
    return state_after_periods(paper::figure3(omega), paper::figure4_settling_periods);
  };
  const double below = 0.36782291, above = 0.36782292;
  EXPECT_EQ(figures::settled_sticking_phases(paper::figure3(below), 1), 2);
  EXPECT_EQ(figures::settled_sticking_phases(paper::figure3(above), 1), 0);
  EXPECT_EQ(figures::followed_sticking_phases(paper::figure3(above), 1, settled_at(below)), 2);
  EXPECT_EQ(figures::followed_sticking_phases(paper::figure3(below), 1, settled_at(above)), 0);
  // Beyond the border orbit of the first one, only the second one is left.
  EXPECT_EQ(figures::followed_sticking_phases(paper::figure3(0.36782298), 1, settled_at(below)), 2);
  EXPECT_EQ(figures::followed_sticking_phases(paper::figure3(0.367823), 1, settled_at(below)), 0);
}

}  // namespace
