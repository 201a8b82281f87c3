// Bifurcation points: each by a smooth function on the periodic orbit and by counting events.
#include "figures/beyond/bifurcations.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "figures/grazing.hpp"
#include "reference/table_reader.hpp"

namespace {

using namespace vibro_impact;
using namespace vibro_impact::figures;

// The value of reference/bifurcation_points.csv, found by the library; where there is one, that of
// the 50-digit generator, reference/located.csv, is asserted as well.
double stored(const std::string &symbol) {
  static const References points = read_references(REFERENCE_DIR "/bifurcation_points.csv");
  return points.at(symbol).value;
}

// Both methods are good to some 1e-14; this is what is asked of the numbers, ten digits.
constexpr double ten_digits = 1e-10;

// Locates the one change of mass `mass` in [below, above] in both ways, and expects it where the
// table has it.
void expect_found(const std::string &symbol, int mass, double below, double above) {
  const std::vector<Change> changes = changes_between(mass, below, above);
  ASSERT_EQ(changes.size(), 1u);
  const std::vector<BifurcationPoint> points = locate(changes.front(), mass);
  ASSERT_EQ(points.size(), 1u);
  const BifurcationPoint &point = points.front();
  EXPECT_TRUE(symbol.starts_with(point.symbol)) << point.symbol;
  EXPECT_NEAR(point.omega.value, point.check, ten_digits);
  EXPECT_NEAR(point.omega.value, stored(symbol), ten_digits);
  EXPECT_LT(point.omega.error, ten_digits);
  fmt::print("  {} {:.17g} +- {:.1e}, by counting {:.17g}\n", symbol, point.omega.value,
             point.omega.error, point.check);
}

// Each by counts and by forces or speeds. The fifth is of a period-two orbit, of which first every
// other chatter of mass 1 fails.
TEST(BifurcationPoints, AreWhereTheCountsChange) {
  expect_found("multi_sliding_mass_1", 1, 0.256, 0.2561);
  expect_found("border_mass_1_2", 1, 0.2965, 0.2966);
  expect_found("border_mass_1_3", 1, 0.3309, 0.331);
  expect_found("border_mass_1_6", 1, 0.40383, 0.40384);
  expect_found("border_mass_1_4", 1, 0.36782, 0.367822);
  expect_found("border_mass_2_4", 2, 0.4747, 0.4748);
  for (double omega : {0.475, 0.48, 0.485, 0.49, 0.495, 0.5})
    for (int mass : {1, 2}) EXPECT_EQ(sticks_from_rest(omega, mass), 0) << omega;
}

// Multi-sliding and all eleven border orbits as points of their curves: of 50 digits, where there
// are any, and of what two other ways found (the table).
TEST(CurvePoints, AreFoundToRounding) {
  const References digits = read_references(REFERENCE_DIR "/located.csv");
  for (const CurveStart &start : starts_in_frequency()) {
    const CurvePoint point = started(start).point;
    const auto known = digits.find(start.name);
    if (known != digits.end()) {
      EXPECT_NEAR(point.at.x, known->second.value, 4e-15) << start.name;
    }
    EXPECT_NEAR(point.at.x, stored(start.name), 1e-14) << start.name;
    EXPECT_LT(point.error, 4e-15) << start.name;
  }
}

// The fixed point of the flights. (How it repels: border_cascade_test.)
TEST(BorderOrbit, HasTheSelfSimilarChatter) {
  const BorderChatter chatter = border_chatter(0.7);
  // The next flight from the fixed point, with pressing acceleration 1 - t: gap zero, same ratio.
  const double s = chatter.flight, speed = s / 2 - s * s / 6;
  EXPECT_NEAR(speed * s - s * s / 2 + s * s * s / 6, 0.0, 1e-16);
  const double next = 0.7 * (s - s * s / 2 - speed);
  EXPECT_NEAR(next / speed, chatter.speed_ratio, 1e-14);
  EXPECT_NEAR(next / (chatter.press_ratio * chatter.press_ratio), speed, 1e-15);
}

TEST(Grazing, OfMass2InFigure5b) {
  const BifurcationPoint point = grazing();
  EXPECT_NEAR(point.omega.value, point.check, 1e-13);
  const References digits = read_references(REFERENCE_DIR "/located.csv");
  for (const double known : {stored(point.symbol), digits.at(point.symbol).value})
    EXPECT_NEAR(point.omega.value, known, 1e-14);
  // The motion with impacts lives on below: from rest it is met 4e-7 earlier.
  const BifurcationPoint rest = impacts_from_rest();
  EXPECT_NEAR(rest.omega.value, stored("impacts_of_mass_2_from_rest_figure5b"), ten_digits);
  EXPECT_LT(rest.omega.value, point.omega.value - 1e-7);
}

// Between these two the attractor depends on the start: the orbit with a complete chatter is stable
// up to its border, but from rest another one is reached.
TEST(Coexistence, OrbitOutlivesTheMotionFromRest) {
  const double from_rest = stored("from_rest_leaves_orbit_mass_1"),
               border = stored("border_mass_1_5"), between = 0.5 * (from_rest + border);
  const Scene scene = paper::stops_of_different_sign(between);
  EXPECT_EQ(sticks_from_rest(between, 1), 0);
  const Scene before = paper::stops_of_different_sign(from_rest - 1e-9);
  const MotionState seed = at_quiet_phase(before, state_after_periods(before, 600));
  const PeriodicOrbit orbit = find_periodic_orbit(scene, seed, 2);
  ASSERT_TRUE(orbit.converged);
  EXPECT_TRUE(orbit.stable());
  const auto events = events_after(scene, orbit.state, 2);
  const auto chatters = chatters_of(events);
  EXPECT_EQ(
      std::count_if(chatters.begin(), chatters.end(),
                    [](const Chatter &chatter) { return chatter.stop == 0 && chatter.complete; }),
      1);
}

}  // namespace
