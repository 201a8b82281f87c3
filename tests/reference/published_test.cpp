// Published results beyond the one number of each row that `make check` compares.
#include "figures/check/results_of_others.hpp"

#include <gtest/gtest.h>

#include <set>

namespace {

using namespace vibro_impact;
using namespace vibro_impact::published;

std::vector<Result> results_of(const std::string &source, const std::string &quantity) {
  std::vector<Result> some;
  for (const Result &result : results(REFERENCE_DIR))
    if (result.source == source && result.quantity == quantity) some.push_back(result);
  return some;
}

TEST(PublishedTable, EveryRowHasItsOwnNameAToleranceAndWhatLimitsIt) {
  std::set<std::string> ids, quantities_printed;
  for (const Result &result : results(REFERENCE_DIR)) {
    EXPECT_TRUE(ids.insert(result.id).second) << result.id;
    EXPECT_GT(result.tolerance, 0.0) << result.id;
    const std::string whose = result.limited_by.substr(0, result.limited_by.find(':'));
    EXPECT_TRUE(whose == "theirs" || whose == "ours" || whose == "both") << result.id;
    quantities_printed.insert(result.quantity);
  }
  EXPECT_EQ(quantities_printed.size(), quantities().size());  // no function without a row
}

// Beside the speed and the multiplier in the table. Their times end at 1e-10 (bisection); 1e-9
// covers what is left of theirs.
TEST(Vivid, TimeOfTheImpactIsThePrintedOne) {
  const std::vector<Result> points = results_of("vivid", "doubling_multiplier");
  ASSERT_FALSE(points.empty());
  for (const Result &point : points) {
    const OneImpactOrbit found = one_impact_orbit(point.parameters);
    const double period = Clock(found.scene.omega).period;
    EXPECT_NEAR(std::remainder(found.impact.time - point.parameters.at("time"), period), 0.0, 1e-9)
        << point.id;
    // The source guarantees its bisection's tolerance, 1e-5.
    EXPECT_NEAR(point.value, -1.0, 1e-5) << point.id;
  }
}

// A coefficient of restitution off by 1e-6 moves every number that depends on it by more than its
// tolerance. At the first impact of a ball nothing depends on it yet.
TEST(PublishedTable, AnErrorOfAMillionthInTheRestitutionIsSeen) {
  for (const std::string quantity :
       {"doubling_multiplier", "fold_multiplier", "impact_time", "chatter_limit", "impact_speed"}) {
    for (Result result : results(REFERENCE_DIR)) {
      Parameters &p = result.parameters;
      if (result.quantity != quantity || !p.contains("r") || p["impact"] == 1.0) continue;
      p["r"] += 1e-6;
      EXPECT_GT(std::abs(result.compute() - result.value), result.tolerance) << result.id;
    }
  }
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
