// What others printed: what the rows of `make check`, which judges every entry, do not show.
#include "figures/published.hpp"

#include <gtest/gtest.h>

#include <set>

namespace {

using namespace vibro_impact;
using namespace vibro_impact::published;

const std::string folder = REFERENCE_DIR;

std::vector<Result> results_of(const std::string &source, const std::string &quantity) {
  std::vector<Result> some;
  for (const Result &result : results(folder))
    if (result.source == source && result.quantity == quantity) some.push_back(result);
  return some;
}

TEST(PublishedTable, EveryRowHasItsOwnNameAToleranceAndWhatLimitsIt) {
  std::set<std::string> ids, named;
  for (const auto &result : results(folder)) {
    EXPECT_TRUE(ids.insert(result.id).second) << result.id;
    EXPECT_GT(result.tolerance, 0.0) << result.id;
    const std::string whose = result.limited_by.substr(0, result.limited_by.find(':'));
    EXPECT_TRUE(whose == "theirs" || whose == "ours" || whose == "both") << result.id;
    named.insert(result.quantity);
  }
  EXPECT_EQ(ids.size(), 140u);
  EXPECT_EQ(named.size(), quantities().size());  // every quantity that is known is published
}

// At the printed speed. Their times end at 1e-10 (bisection); a multiplier feels the error of a
// time or a position divided by the impact speed, where 1e-9 covers what is left of theirs.
TEST(Vivid, MultiplierAndTimeOfTheImpactAreThePrintedOnes) {
  const auto points = results_of("vivid", "amplitude_of_speed");
  ASSERT_EQ(points.size(), 24u);
  for (const Result &point : points) {
    Parameters p = point.parameters;
    p["A"] = point.compute();
    const OneImpactOrbit found = one_impact_orbit(p);
    const double period = Clock(p["omega"]).period, speed = p["speed"];
    EXPECT_NEAR(std::remainder(found.impact.time - p["time"], period), 0.0, 1e-9) << point.id;
    const double multiplier = found.doubling_multiplier();
    EXPECT_NEAR(multiplier, p["multiplier"], 1e-9 / speed) << point.id;
    // What the source promises of its points: 1e-5, its bisection's tolerance.
    EXPECT_NEAR(multiplier, -1.0, 1e-5 + 1e-9 / speed);
    // r^2 exp(-0.04 * two periods): Liouville.
    const auto both = found.orbit.multipliers.at(0) * found.orbit.multipliers.at(1);
    EXPECT_NEAR(both.real(), 0.81 * std::exp(-0.08 * period), 1e-10) << point.id;
  }
}

// Siconos locates an impact where the gap is below some 3e-13: that error over the impact speed, in
// the time, is left by every impact and grows with the number of them. The speed feels it by the
// pressing acceleration, 10 near the stop in all of them, and the integrator's error in the
// displacement, 3e-13, by the frequency, 316 at most.
TEST(Siconos, TolerancesAndSpeedsOfTheImpactsFollowFromTheirTolerance) {
  const auto impacts = results_of("siconos", "impact_time");
  ASSERT_EQ(impacts.size(), 44u);
  for (const Result &impact : impacts) {
    const double velocity = impact.parameters.at("velocity_before");
    EXPECT_LE(impact.tolerance, 3e-13 / std::abs(velocity) + 1e-15) << impact.id;
    const double frequency = std::sqrt(largest_eigenvalue_bound(ball_of(impact.parameters)));
    EXPECT_NEAR(impact_of_ball(impact.parameters).velocity_before, velocity,
                10.0 * impact.tolerance + 3e-13 * frequency)
        << impact.id;
  }
}

// A coefficient of restitution off by 1e-6 must be seen: the tolerances are not wide. Near grazing
// the amplitude depends on the restitution with the square of the speed only, the multiplier more.
TEST(PublishedTable, AnErrorOfAMillionthInTheRestitutionIsSeen) {
  int seen = 0;
  for (Result result : results(folder)) {
    if (!result.parameters.contains("r") || result.parameters["impact"] == 1.0) continue;
    const bool formula = result.kind == "formula" && result.limited_by.starts_with("ours");
    if (!formula && result.quantity != "amplitude_of_speed" && result.source != "siconos") continue;
    result.parameters["r"] += 1e-6;
    const double changed = result.compute(), by = std::abs(changed - result.value);
    double multiplier = 0.0;
    if (result.quantity == "amplitude_of_speed") {
      result.parameters["A"] = changed;
      multiplier = std::abs(one_impact_orbit(result.parameters).doubling_multiplier() -
                            result.parameters["multiplier"]);
    }
    EXPECT_TRUE(by > (formula ? 1e3 : 1.0) * result.tolerance ||
                multiplier > 1e-9 / result.parameters["speed"])
        << result.id;
    ++seen;
  }
  EXPECT_GE(seen, 25 + 60);
}

TEST(PublishedTable, UnknownParametersAndQuantitiesAreNamed) {
  EXPECT_THROW(read_parameters("t.csv", "omega"), std::runtime_error);
  EXPECT_THROW(read_parameters("t.csv", "omega=x"), std::runtime_error);
  Result result;
  EXPECT_THROW(result.compute(), std::runtime_error);
  result.quantity = "chatter_limit";
  EXPECT_THROW(result.compute(), std::runtime_error);
}

}  // namespace
