// The first root where the coefficients are of very different sizes, as r = 1e-300 makes them.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "polynomials.hpp"
#include "simulation/flight/first_root.hpp"

namespace {

using namespace vibro_impact;
using namespace vibro_impact::testing;

// Polynomials of which the squares underflow, or overflow, have the roots of others.
TEST(FirstRootOfAnySize, DoesNotDependOnTheUnits) {
  for (const int power : {0, -300, -500, -900, -1000, 300, 500, 1000, 1016})
    for (unsigned seed = 1; seed <= 50; ++seed) {
      Polynomial p, small;
      for (std::size_t n = 0; n <= 7; ++n) {
        p.coefficient[n] = n == 0 ? 0.3 : std::cos(static_cast<double>(seed * (n + 1)));
        small.coefficient[n] = std::ldexp(p.coefficient[n], power);
      }
      end_at(p, 7);
      end_at(small, 7);
      Counters counters;
      const auto root = first_root(p, 1.0, counters), other = first_root(small, 1.0, counters);
      ASSERT_EQ(root.has_value(), other.has_value()) << seed;
      if (!root) continue;
      EXPECT_NEAR(other->at, root->at, power < -950 ? 1e-13 : 1e-15) << power << " " << seed;
      EXPECT_NEAR(std::ldexp(other->slope, -power), root->slope, power < -950 ? 1e-12 : 1e-14);
    }
}

// No root is told of motion beyond the range of double precision.
TEST(FirstRootOfAnySize, IsNotToldOfWhatIsNotFinite) {
  Counters none;
  EXPECT_FALSE(first_root(rounded({NAN, 0.0, 0.0, 0.0}), 1.0, none));
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {infinity, -infinity, std::numeric_limits<double>::quiet_NaN()})
    for (std::size_t n = 0; n <= 7; ++n) {
      Polynomial p = rounded({1.0, -1.0, 0.5, -2.0, 0.1, 0.2, -0.3, 0.1});
      p.coefficient[n] = bad;
      if (n == 0 && bad < 0.0) continue;  // it starts beyond its stop
      Counters counters;
      EXPECT_FALSE(first_root(p, 1.0, counters)) << n << " " << bad;
    }
}

// What is known exactly, a gap and its speed, of any size; the others between rounding and one. No
// value before the root is negative, on a grid of 23 points a decade in extended precision, and the
// root is one to 1e-12 of its terms, or to where their products underflow.
TEST(FirstRootOfAnySize, IsNeitherMissedNorPassed) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> any(0.0, 1.0);
  int found = 0;
  for (int seed = 0; seed < 2000; ++seed) {
    Polynomial p;
    end_at(p, 3 + seed % 5);
    const auto size = [&](double smallest) { return std::pow(10.0, smallest * any(random)); };
    for (int n = 0; n <= p.order; ++n)
      p.coefficient[static_cast<std::size_t>(n)] =
          (n > 0 && any(random) < 0.5 ? -1.0 : 1.0) * size(n < 2 ? -300.0 : -17.0);
    Counters counters;
    const auto root = first_root(p, 1.0, counters);
    const double end = root ? root->at : 1.0;
    found += root.has_value();
    EXPECT_LE(counters.root_iterations, 150) << seed;
    if (root) {
      EXPECT_LE(std::abs(value_of(p, end)), 1e-12L * size_of(p, end) + 1e-308L) << seed;
    }
    for (long double u = 1e-310L; u < end * (1.0L - 1e-12L); u *= 1.1L)
      ASSERT_GE(value_of(p, u), 0.0L) << seed << " at " << u << " of " << end;
  }
  EXPECT_GT(found, 500);
}

// The value at this root is zero, and the inverse of its series overflows.
TEST(FirstRootOfAnySize, IsFoundWhereTheValueIsZero) {
  Counters counters;
  const auto root =
      first_root(rounded({2.7812077813809178e-197, 1.1217003537489976e-92, -8.3479354679376937e-16,
                          4.2588750532097565e-71, 5.7844852586960428e-91, 3.7263156780345552e-41}),
                 1.0, counters);
  ASSERT_TRUE(root);
  EXPECT_NEAR(root->at, 1.1217003537489976e-92 / 8.3479354679376937e-16, 1e-90);
  EXPECT_LE(counters.root_iterations, 64);
}

// From the first 1e-302 to the root at 1e-35 there are 900 factors of two.
TEST(FirstRootOfAnySize, ClimbsInFewSteps) {
  Counters counters;
  const auto root = first_root(rounded({1e-302, 0.0, 1e-35, -1.0}), 1.0, counters);
  ASSERT_TRUE(root);
  EXPECT_NEAR(root->at, 1e-35, 1e-50);
  EXPECT_LE(counters.root_iterations, 64);
}

}  // namespace
