// What others printed, entry by entry: the rows of `make check`, and what a row does not show.
#include "figures/published_results.hpp"

#include <gtest/gtest.h>

#include <cctype>
#include <ostream>
#include <set>

namespace vibro_impact::figures {

// What the test's name shows of a parameter.
void PrintTo(const PublishedResult &result, std::ostream *out) {
  *out << result.quantity;
}

}  // namespace vibro_impact::figures

namespace {

using namespace vibro_impact;
using namespace vibro_impact::figures;

const std::string folder = REFERENCE_DIR;

class Published : public ::testing::TestWithParam<PublishedResult> {};

// The tolerance of a row is that of its source (printed digits, tolerance of its method) or, for a
// formula, some hundred roundings; `limited_by` says which.
TEST_P(Published, IsReproduced) {
  const PublishedResult &result = GetParam();
  EXPECT_NEAR(result.compute(), result.value, result.tolerance) << result.limited_by;
}

std::string name_of(const ::testing::TestParamInfo<PublishedResult> &info) {
  std::string name = info.param.source + "_" + info.param.id;
  for (char &c : name)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  return name;
}

INSTANTIATE_TEST_SUITE_P(Results, Published, ::testing::ValuesIn(published_results(folder)),
                         name_of);

TEST(PublishedTables, EveryRowHasItsOwnNameATolerancAndWhatLimitsIt) {
  const auto results = published_results(folder);
  EXPECT_GE(results.size(), 100u);
  std::set<std::string> ids;
  for (const auto &result : results) {
    EXPECT_TRUE(ids.insert(result.id).second) << result.id;
    EXPECT_GT(result.tolerance, 0.0) << result.id;
    const std::string whose = result.limited_by.substr(0, result.limited_by.find(':'));
    EXPECT_TRUE(whose == "theirs" || whose == "ours" || whose == "both") << result.id;
  }
  // Every quantity that is known is published.
  std::set<std::string> quantities;
  for (const auto &result : published::single_results(folder))
    quantities.insert(result.quantity.substr(0, result.quantity.find(' ')));
  EXPECT_EQ(quantities.size(), published::quantities().size());
}

// At the printed speed. Their times end at 1e-10 (bisection); a multiplier feels the error of a
// time or a position divided by the impact speed, where 1e-9 covers what is left of theirs.
TEST(Vivid, MultiplierAndTimeOfTheImpactAreThePrintedOnes) {
  const auto points = published::vivid_points(folder);
  ASSERT_EQ(points.size(), 24u);
  for (const auto &point : points) {
    const OneImpactOrbit found = point.orbit_at(point.amplitude_of_speed());
    const double period = Clock(point.omega).period;
    EXPECT_NEAR(std::remainder(found.impact.time - point.time, period), 0.0, 1e-9) << point.line;
    const double multiplier = found.doubling_multiplier();
    EXPECT_NEAR(multiplier, point.multiplier, 1e-9 / point.speed) << point.curve << point.line;
    // What the source promises of its points: 1e-5, its bisection's tolerance.
    EXPECT_NEAR(multiplier, -1.0, 1e-5 + 1e-9 / point.speed);
    // r^2 exp(-0.04 * two periods): Liouville.
    const auto both = found.orbit.multipliers.at(0) * found.orbit.multipliers.at(1);
    EXPECT_NEAR(both.real(), 0.81 * std::exp(-0.08 * period), 1e-10) << point.line;
  }
}

// The speed feels the error of the time by the pressing acceleration, 10 near the stop in all of
// them, and the integrator's error in the displacement, 3e-13, by the frequency, 316 at most.
TEST(Siconos, SpeedsOfTheImpactsAreThePrintedOnes) {
  const auto impacts = published::siconos_impacts(folder);
  ASSERT_GE(impacts.size(), 40u);
  for (const auto &impact : impacts) {
    const Scene scene = published::siconos_scene(impact.table);
    const double frequency = std::sqrt(largest_eigenvalue_bound(scene));
    EXPECT_NEAR(published::impact_of_library(impact).velocity_before, impact.velocity,
                10.0 * published::siconos_tolerance(impact) + 3e-13 * frequency)
        << impact.table << " " << impact.line;
  }
}

// A coefficient of restitution off by 1e-6 must be seen: the tolerances are not wide.
TEST(PublishedTables, AnErrorOfAMillionthInTheRestitutionIsSeen) {
  int seen = 0;
  for (auto point : published::vivid_points(folder)) {
    point.restitution += 1e-6;
    // Near grazing the amplitude depends on the restitution with the square of the speed only.
    const double amplitude = point.amplitude_of_speed(),
                 multiplier = point.orbit_at(amplitude).doubling_multiplier();
    EXPECT_TRUE(std::abs(amplitude - point.amplitude) > 1e-10 ||
                std::abs(multiplier - point.multiplier) > 1e-9 / point.speed)
        << point.line;
    ++seen;
  }
  for (const auto &impact : published::siconos_impacts(folder)) {
    if (impact.impact == 1) continue;  // before any restitution
    Scene scene = published::siconos_scene(impact.table);
    scene.restitution += 1e-6;
    std::size_t count = 0;
    for (const Event &event : published::events_to(scene, 10.0, true)) {
      if (event.kind != EventKind::impact || ++count != impact.impact) continue;
      EXPECT_GT(std::abs(event.time - impact.time), published::siconos_tolerance(impact))
          << impact.table << " " << impact.line;
    }
    ++seen;
  }
  EXPECT_GE(seen, 60);
}

TEST(PublishedTables, UnknownParametersAndQuantitiesAreNamed) {
  EXPECT_THROW(published::read_parameters("t.csv", "omega"), std::runtime_error);
  EXPECT_THROW(published::read_parameters("t.csv", "omega=x"), std::runtime_error);
  EXPECT_THROW(published::read_parameters("t.csv", "omega=1")["r"], std::runtime_error);
  EXPECT_THROW(published::siconos_scene("BouncingBall"), std::runtime_error);
}

}  // namespace
