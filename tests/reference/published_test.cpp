// What others printed, beyond the one number of each row that `make check` judges, and how the
// library approaches what is printed as a limit only.
#include "figures/published.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/special_functions/airy.hpp>
#include <set>
#include "tests/rates.hpp"

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

// At the printed speed. Their times end at 1e-10 (bisection). A multiplier feels the error of a
// time or a position divided by the impact speed, where 1e-9 covers what is left of theirs.
TEST(Vivid, MultiplierAndTimeOfTheImpactAreThePrintedOnes) {
  const std::vector<Result> points = results_of("vivid", "amplitude_of_speed");
  ASSERT_FALSE(points.empty());
  for (const Result &point : points) {
    Parameters p = point.parameters;
    p["A"] = point.compute();
    const OneImpactOrbit found = one_impact_orbit(p);
    const double period = Clock(p["omega"]).period, speed = p["speed"];
    EXPECT_NEAR(std::remainder(found.impact.time - p["time"], period), 0.0, 1e-9) << point.id;
    const double multiplier = found.doubling_multiplier();
    EXPECT_NEAR(multiplier, p["multiplier"], 1e-9 / speed) << point.id;
    // The source guarantees its bisection's tolerance, 1e-5.
    EXPECT_NEAR(multiplier, -1.0, 1e-5 + 1e-9 / speed);
    // Liouville: the product is r^2 exp(-0.04 * two periods).
    const auto product = found.orbit.multipliers.at(0) * found.orbit.multipliers.at(1);
    EXPECT_NEAR(product.real(), 0.81 * std::exp(-0.08 * period), 1e-10) << point.id;
  }
}

// Siconos locates an impact where the gap is below some 3e-13. Every impact leaves that error over
// the impact speed in the time. The speed feels it by the pressing acceleration, which is 10 near
// the stop in all rows, and the integrator's error in the displacement, 3e-13, by the frequency.
TEST(Siconos, TolerancesAndSpeedsOfTheImpactsFollowFromTheirTolerance) {
  const std::vector<Result> impacts = results_of("siconos", "impact_time");
  ASSERT_FALSE(impacts.empty());
  for (const Result &impact : impacts) {
    const double velocity = impact.parameters.at("velocity_before");
    EXPECT_LE(impact.tolerance, 3e-13 / std::abs(velocity) + 1e-15) << impact.id;
    const double frequency =
        std::sqrt(vibro_impact::testing::largest_eigenvalue_bound(ball_of(impact.parameters)));
    EXPECT_NEAR(impact_of_ball(impact.parameters).velocity_before, velocity,
                10.0 * impact.tolerance + 3e-13 * frequency)
        << impact.id;
  }
}

// A coefficient of restitution off by 1e-6 moves every number that depends on it by more than its
// tolerance. At the first impact of a ball nothing depends on it yet. The amplitude of an orbit
// near grazing depends on it with the square of the speed only, but its multiplier does at once.
TEST(PublishedTable, AnErrorOfAMillionthInTheRestitutionIsSeen) {
  for (const std::string quantity :
       {"amplitude_of_speed", "impact_time", "chatter_limit", "impact_speed", "doubling_speed"}) {
    for (Result result : results(REFERENCE_DIR)) {
      Parameters &p = result.parameters;
      if (result.quantity != quantity || !p.contains("r") || p["impact"] == 1.0) continue;
      p["r"] += 1e-6;
      const double computed = result.compute();
      bool seen = std::abs(computed - result.value) > result.tolerance;
      if (quantity == "amplitude_of_speed") {
        p["A"] = computed;
        const double multiplier = one_impact_orbit(p).doubling_multiplier();
        seen = seen || std::abs(multiplier - p["multiplier"]) > 1e-9 / p["speed"];
      }
      EXPECT_TRUE(seen) << result.id;
    }
  }
}

// The lumped bar: the contact outlasts 2 L / c by the width of the front, which the lattice
// disperses into an Airy function. The force returns to zero where the front has brought half its
// step, that is at xi with int_0^xi Ai(-s) ds = 1/6, so that
//   T_N / T = 1 + xi / (2 4^(1/3)) N^(-2/3) + ...
TEST(Bar, ContactTimeFallsToTheLimitAsTheDispersedFrontSays) {
  const auto integral = [](double xi) {
    return boost::math::quadrature::gauss_kronrod<double, 31>::integrate(
        [](double s) { return boost::math::airy_ai(-s); }, 0.0, xi);
  };
  const double xi = zero([&](double x) { return integral(x) - 1.0 / 6.0; }, 0.0, 1.0).value,
               constant = xi / (2.0 * std::cbrt(4.0)),
               limit = 2.0 / std::sqrt(elasticity / density);
  EXPECT_NEAR(constant, 0.1290, 5e-5);
  std::vector<double> scaled;
  for (int n : {25, 50, 100, 200, 400}) {
    scaled.push_back((contact_time(n) / limit - 1.0) * std::pow(n, 2.0 / 3.0));
    // The rest is of the next order, N^(-2/3), and its constant was measured as 0.073.
    EXPECT_NEAR(scaled.back(), constant, 0.08 * std::pow(n, -2.0 / 3.0)) << n;
  }
  EXPECT_TRUE(std::is_sorted(scaled.begin(), scaled.end()));
}

// Budd and Dux give the limit of a chatter to leading order in its first speed: the rest falls with
// the cube of the speed.
TEST(BuddAndDux, TheChatterLimitIsOfLeadingOrder) {
  const auto excess = [](double speed) {
    const Parameters p{{"omega", 2.0}, {"r", 0.5}, {"stop", 0.0}, {"speed", speed}};
    return quantities().at("first_order_chatter_limit")(p) - 4.0 * speed;
  };
  // The lesser one is 2.7e-8 of a time of 4e-3, which is known to 1e-16 or so.
  EXPECT_NEAR(excess(2e-3) / excess(1e-3), 8.0, 1e-3);
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
