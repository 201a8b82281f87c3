// What the search for a first root costs: few guaranteed steps, and none where one bound will do.
#include <gtest/gtest.h>

#include <cmath>

#include "polynomials.hpp"
#include "simulation/flight/first_root.hpp"

namespace {

using namespace vibro_impact;
using namespace vibro_impact::testing;

// The way back of a mass to the stop it has just left, a bent parabola, against bisection. Most
// searches of a chatter are of this kind: they take two or three steps.
TEST(FirstRootSteps, OfAReturnTakesFewSteps) {
  Counters counters;
  int found = 0;
  for (unsigned seed = 1; seed <= 2000; ++seed) {
    const double bend = 0.6 * std::abs(std::sin(seed));
    Coefficients coefficients{0.0L, 0.8L, -1.0L};
    for (std::size_t n = 3; n <= 11; ++n)
      coefficients.push_back(std::pow(bend, static_cast<double>(n - 2)) *
                             std::cos(seed * static_cast<double>(n)) / 3.0);
    const Polynomial gap = rounded(coefficients);
    const auto root = first_root(gap, 1.0, counters);
    long double before = 0.0L, beyond = 0.0L;
    for (int i = 1; i <= 1000 && beyond == 0.0L; ++i) {
      const long double u = i / 1000.0L;
      (value_of(gap, u) > 0.0L ? before : beyond) = u;
    }
    ASSERT_EQ(root.has_value(), beyond > 0.0L) << seed;
    if (!root) continue;
    for (int i = 0; i < 80; ++i) {
      const long double u = (before + beyond) / 2.0L;
      (value_of(gap, u) > 0.0L ? before : beyond) = u;
    }
    const auto at = static_cast<double>(before);
    // The slope is steeper than 0.3: three roundings of the terms, of order one.
    EXPECT_NEAR(root->at, at, 1e-15) << seed;
    EXPECT_NEAR(root->slope, static_cast<double>(slope_of(gap, before)), 4e-15) << seed;
    ++found;
  }
  EXPECT_GT(found, 1000);
  EXPECT_LT(counters.root_iterations, 2.5 * found);
}

TEST(FirstRootSteps, PassesADipInFewSteps) {
  // (u - 1/2)^2 + d: twenty guaranteed steps and more where each gains a bit, as many to leave.
  for (double missed : {1e-14, 1e-12, 1e-9, 1e-6}) {
    Counters counters;
    EXPECT_FALSE(first_root(rounded({0.25L + missed, -1.0L, 1.0L}), 1.0, counters)) << missed;
    EXPECT_LE(counters.root_iterations, 6) << missed;
  }
}

TEST(FirstRootSteps, DismissesAClearlyPositivePolynomialByOneBound) {
  Counters counters;
  EXPECT_FALSE(first_root(rounded({1.0L, -0.3L, 0.2L, -0.6L}), 1.0, counters));
  EXPECT_EQ(counters.roots_dismissed, 1);
  EXPECT_EQ(counters.roots_searched, 0);
  EXPECT_EQ(counters.root_iterations, 0);
}

TEST(FirstRootSteps, ConvergesQuadraticallyAtATransversalRoot) {
  Counters counters;
  // cos-like: 1 - u^2 + u^4 / 6, first root 0.8... A linear method needs 25 steps and more.
  ASSERT_TRUE(first_root(rounded({1.0L, 0.0L, -1.6L, 0.0L, 0.3L}), 1.0, counters));
  EXPECT_LE(counters.root_iterations, 8);
}

}  // namespace
