// The list of frequencies at which the sticking phases of the motion from rest change is complete:
// between neighbours of the list the number of phases stays the same, and at each it changes. Where
// the page says that attractors coexist, two are found.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "figures/measures/runs.hpp"
#include "reference/numbers/checked_number.hpp"
#include "reference/numbers/quantities.hpp"
#include "tests/support/events.hpp"
#include "vibro_impact/analysis/analysis.hpp"

namespace {

using namespace vibro_impact;

// The frequencies of a mass from 0.25 to 0.5, as the table of references has them, with both ends.
std::vector<double> frequencies(int mass) {
  std::vector<double> known{0.25, 0.5};
  for (const auto &number : numbers::checked_numbers(REFERENCE_DIR))
    if (number.quantity == "changing_frequency" && number.arguments.mass("mass") == mass &&
        numbers::change_in(number.arguments) != numbers::Change::followed)
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
      const int count = phases(from);
      EXPECT_NE(count, before) << "mass " << mass << " at " << known[i - 1];
      for (int k = 1; k <= 10; ++k) {
        const double omega = from + 0.1 * k * (to - from);
        EXPECT_EQ(phases(omega), count) << "mass " << mass << " at " << omega;
      }
      before = count;
    }
  }
  EXPECT_EQ(changes, 13u);
}

// The shortest sticking phase of a mass in the last four of 154 periods from rest.
double shortest_stick(double omega, int mass) {
  const double period = Clock(omega).period;
  double stick = -1.0, shortest = infinity;
  for (const Event &event :
       vibro_impact::testing::events_of(paper::figure3(omega), 150.0 * period, 154.0 * period)) {
    if (event.mass != mass) continue;
    if (event.kind == EventKind::stick) stick = event.time;
    if (event.kind == EventKind::release && stick > 0.0)
      shortest = std::min(shortest, event.time - stick);
  }
  return shortest;
}

// On the side with more phases, at a distance of 1e-6 and of 1e-8 from a change: towards a border
// orbit the shortest phase vanishes, about as the root of the distance, and towards a multi-sliding
// bifurcation both parts of the split phase keep their lengths.
TEST(StickingChanges, AreBorderOrbitsWhereAPhaseVanishes) {
  int border_orbits = 0;
  for (const auto &number : numbers::checked_numbers(REFERENCE_DIR)) {
    const bool border = number.id.starts_with("border_mass_");
    if (!border && !number.id.starts_with("multi_sliding_")) continue;
    const int mass = number.arguments.mass("mass");
    const auto phases = [&](double distance) {
      return figures::settled_sticking_phases(paper::figure3(number.value + distance), mass);
    };
    const double inside = phases(1e-6) > phases(-1e-6) ? 1.0 : -1.0;
    const double ratio = shortest_stick(number.value + 1e-8 * inside, mass) /
                         shortest_stick(number.value + 1e-6 * inside, mass);
    EXPECT_EQ(ratio < 0.2, border) << number.id;
    EXPECT_EQ(ratio > 0.8, !border) << number.id;
    border_orbits += border;
  }
  EXPECT_EQ(border_orbits, 10);
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

// Between 0.47 and 0.5 the start matters: both masses then have other numbers of impacts a period.
TEST(Attractors, CoexistBetween047And05) {
  Scene scene = paper::figure3(0.493);
  const auto impacts_from = [&](double x1) {
    scene.displacement = {x1, 0.0};
    const OrbitRecord record = record_of(scene);
    EXPECT_EQ(record.period, 1) << x1;
    return record.counts.impacts;
  };
  EXPECT_EQ(impacts_from(0.2), (std::vector{4, 5}));
  EXPECT_EQ(impacts_from(0.6), (std::vector{5, 4}));
}

// Figure 5(b), 2e-7 below the frequency at which the settled motion without hits grazes: from rest
// mass 2 hits its stop, and the motion without hits is that with the stop put back.
TEST(Attractors, CoexistNextToTheGrazeOfFigure5b) {
  Scene scene = with(paper::figure5b(), "omega", 0.2995198);
  EXPECT_GT(record_of(scene).counts.impacts[1], 0);
  Scene without_stop = scene;
  without_stop.stops.pop_back();
  const MotionState start = state_after_periods(without_stop, paper::figure4_settling_periods);
  scene.displacement = start.displacement;
  scene.velocity = start.velocity;
  const OrbitRecord record = record_of(scene);
  EXPECT_EQ(record.period, 1);
  EXPECT_EQ(record.counts.impacts[1], 0);
}

}  // namespace
