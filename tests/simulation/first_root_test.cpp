// The first root of a polynomial on (0, 1]: never passed over, relatively accurate after deflation,
// and found in few steps.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <random>
#include <vector>

#include "simulation/flight/polynomial.hpp"

namespace {

using namespace vibro_impact;
using namespace vibro_impact::detail;

constexpr double epsilon = std::numeric_limits<double>::epsilon();

using Coefficients = std::vector<long double>;

Polynomial rounded(const Coefficients &coefficients) {
  Polynomial p;
  p.coefficient.fill(NAN);  // what lies beyond the padding must not be read
  p.order = static_cast<int>(coefficients.size()) - 1;
  std::fill_n(p.coefficient.begin() + p.order + 1, 4, 0.0);
  for (std::size_t n = 0; n < coefficients.size(); ++n)
    p.coefficient[n] = static_cast<double>(coefficients[n]);
  return p;
}

Coefficients times(const Coefficients &a, const Coefficients &b) {
  Coefficients product(a.size() + b.size() - 1, 0.0L);
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j) product[i + j] += a[i] * b[j];
  return product;
}

long double value_of(const Polynomial &p, long double u) {
  long double value = 0.0L;
  for (int n = p.order; n >= 0; --n) value = value * u + p.coefficient[static_cast<std::size_t>(n)];
  return value;
}

long double slope_of(const Polynomial &p, long double u) {
  long double slope = 0.0L;
  for (int n = p.order; n >= 1; --n)
    slope = slope * u + n * static_cast<long double>(p.coefficient[static_cast<std::size_t>(n)]);
  return slope;
}

// Sum of the moduli of the terms: the scale of the rounding of a value of p.
double size_of(const Polynomial &p, double u) {
  double size = 0.0;
  for (int n = p.order; n >= 0; --n)
    size = size * u + std::abs(p.coefficient[static_cast<std::size_t>(n)]);
  return size;
}

std::optional<Root> first(const Polynomial &p, double limit = 1.0) {
  Counters counters;
  return first_root(p, limit, counters);
}

struct Allowed {
  double roundings;             // of the terms there, in the value at the root
  long long steps;              // of the search
  long double smallest, ratio;  // of the grid
};

// What is told is a root, to rounding, or to where the products of its terms underflow; no value
// before it is negative, on a grid in extended precision. Where none is told none is negative up to
// 1. Returns whether there is a root.
bool expect_neither_missed_nor_passed(const Polynomial &p, const Allowed &allowed) {
  Counters counters;
  const auto root = first_root(p, 1.0, counters);
  const double end = root ? root->u : 1.0;
  EXPECT_LE(counters.root_iterations, allowed.steps);
  if (root) {
    const double rounding = allowed.roundings * epsilon * size_of(p, end);
    EXPECT_LE(std::abs(value_of(p, end)), rounding + 1e-308L);
    EXPECT_NEAR(root->slope, static_cast<double>(slope_of(p, end)), 8.0 * rounding / end);
  }
  for (long double u = allowed.smallest; u < end * (1.0L - 1e-12L); u *= allowed.ratio)
    EXPECT_GE(value_of(p, u), 0.0L) << "at " << u << " of " << end;
  return root.has_value();
}

// Roots on both sides of the interval and in it, and pairs beside it. The steps are no measure: no
// flight has coefficients so far above its values.
TEST(FirstRoot, OfProductsOfFactors) {
  std::mt19937 generator(2006);
  std::uniform_real_distribution<double> place(-1.0, 2.0), even(-1.0, 1.0);
  std::uniform_int_distribution<int> some(0, 3);
  int found = 0;
  for (int trial = 0; trial < 4000; ++trial) {
    SCOPED_TRACE(trial);
    Coefficients p{1.0L};
    for (int roots = 1 + some(generator); roots > 0; --roots)
      p = times(p, {-static_cast<long double>(place(generator)), 1.0L});
    for (int pairs = some(generator); pairs > 0; --pairs) {
      const long double x = place(generator), y = 0.05 + std::abs(even(generator));
      p = times(p, {x * x + y * y, -2.0L * x, 1.0L});
    }
    if (p[0] < 0.0L)
      for (long double &c : p) c = -c;
    found += expect_neither_missed_nor_passed(rounded(p), {4.0, 10'000, 1e-3L, 1.005L});
  }
  EXPECT_GT(found, 1000);
}

// The steps of order five start where the root ahead is certain to be the only one near, which the
// moduli of the coefficients tell; here their signs hide a wiggle.
TEST(FirstRoot, OfWigglyPolynomials) {
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> even(-1.0, 1.0);
  int found = 0;
  for (int trial = 0; trial < 4000; ++trial) {
    SCOPED_TRACE(trial);
    Coefficients p{0.02 + 0.1 * std::abs(even(generator)), -0.1 * std::abs(even(generator))};
    double size = 1.0;
    for (int n = 2; n <= 12; ++n) p.push_back(size *= 1.8 * even(generator) + 0.2);
    found += expect_neither_missed_nor_passed(rounded(p), {8.0, 150, 1e-3L, 1.001L});
  }
  EXPECT_GT(found, 1000);
}

// What is known exactly, a gap and its speed, of any size; the others between rounding and one.
// Some in units that bring them next to the largest double.
TEST(FirstRoot, OfCoefficientsOfAnySize) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> any(0.0, 1.0);
  int found = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    SCOPED_TRACE(trial);
    Polynomial p;
    p.order = 3 + trial % 5;
    const double unit = trial % 4 == 0 ? 0x1p1000 : 1.0;
    const auto size = [&](double smallest) { return std::pow(10.0, smallest * any(random)); };
    for (int n = 0; n <= p.order; ++n)
      p.coefficient[static_cast<std::size_t>(n)] =
          (n > 0 && any(random) < 0.5 ? -unit : unit) * size(n < 2 ? -300.0 : -17.0);
    found += expect_neither_missed_nor_passed(p, {4500.0, 150, 1e-310L, 1.1L});
  }
  EXPECT_GT(found, 500);
}

// (u - 1/2)^2 + d: rounding of its value is 1.1e-16 (half an epsilon of the sum of its terms, 1).
TEST(FirstRoot, DecidesGrazingOfADipDownTo1e15) {
  for (double missed : {1e-15, 1e-12, 1e-6, 1e-2}) {
    Counters counters;
    EXPECT_FALSE(first_root(rounded({0.25L + missed, -1.0L, 1.0L}), 1.0, counters)) << missed;
    // Twenty steps and more where each gains a bit, as many to leave.
    EXPECT_LE(counters.root_iterations, 6) << missed;
  }
  for (double depth : {1e-15, 1e-12, 1e-6, 1e-2}) {
    const auto root = first(rounded({0.25L - depth, -1.0L, 1.0L}));
    ASSERT_TRUE(root) << depth;
    // The value's rounding over the slope 2 sqrt(depth).
    EXPECT_NEAR(root->u, 0.5 - std::sqrt(depth), 2.2e-16 / std::sqrt(depth)) << depth;
  }
  const auto touch = first(rounded({0.25L, -1.0L, 1.0L}));
  ASSERT_TRUE(touch);
  // Within sqrt(eps) of the tangency the polynomial cannot be told from zero.
  EXPECT_NEAR(touch->u, 0.5, 2e-8);
}

TEST(FirstRoot, DeflatedZerosKeepSmallSpeedsRelativelyAccurate) {
  // g = v u - a u^2 / 2 + b u^3: next impact at u = 2 v / a + 8 b v^2 / a^3 + O(v^3), however small
  // v is.
  for (double v : {1e-3, 1e-8, 1e-14, 1e-30}) {
    const double a = 0.7, b = 0.3;
    const Polynomial p = rounded({0.0L, v, -a / 2.0L, b});
    const auto root = first(p);
    ASSERT_TRUE(root) << v;
    long double exact = 2.0L * v / a;
    for (int i = 0; i < 5; ++i) {  // v - a u / 2 + b u^2 = 0
      const long double q = v - a / 2.0L * exact + static_cast<long double>(b) * exact * exact;
      exact -= q / (-a / 2.0L + 2.0L * b * exact);
    }
    // A few roundings, relative to the root.
    EXPECT_NEAR(root->u, static_cast<double>(exact), 4 * epsilon * root->u) << v;
    EXPECT_NEAR(root->slope, static_cast<double>(slope_of(p, exact)), 8 * epsilon * v) << v;
  }
}

TEST(FirstRoot, AtTheLimitOrAtTheStart) {
  // After a release: u^2 (or u^3) times a line that reaches zero at 1/4. Exact in binary.
  EXPECT_EQ(first(rounded({0.0L, 0.0L, 1.0L, -4.0L})).value().u, 0.25);
  EXPECT_EQ(first(rounded({0.0L, 0.0L, 0.0L, 1.0L, -4.0L})).value().u, 0.25);
  EXPECT_EQ(first(rounded({1.0L, -1.0L})).value().u, 1.0);
  EXPECT_EQ(first(rounded({0.5L, -1.0L}), 0.5).value().u, 0.5);
  EXPECT_FALSE(first(rounded({0.5L, -1.0L}), std::nextafter(0.5, 0.0)));
  EXPECT_FALSE(first(rounded({1.0L + 1e-12L, -1.0L})));
  EXPECT_FALSE(first(rounded({0.0L, 0.0L, 0.0L}))) << "what stays at zero never returns to it";
  EXPECT_FALSE(first(rounded({0.0L, 0.0L, 0.0L, 0.0L})));
  EXPECT_EQ(first(rounded({0.0L, -1e-20L, 1.0L})).value().u, 0.0) << "leaves through zero";
  EXPECT_EQ(first(rounded({-1.0L, 5.0L})).value().u, 0.0);
  EXPECT_FALSE(first(rounded({0.0L, 1e-300L})));
}

// No root is told of motion beyond the range of double precision.
TEST(FirstRoot, IsNotToldOfWhatIsNotFinite) {
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

// Searches that went wrong once, or crept: a step lost to cancellation, guaranteed steps of 6e-6 u
// all the way up from 1e-25, a value of zero whose inverse overflows, 900 factors of two, steps of
// 1e-18 where the bound of a derivative was that at 1.
TEST(FirstRoot, IsFoundWhereTheSearchOnceFailed) {
  struct Search {
    Coefficients polynomial;
    double root, error;
  };
  for (const auto &[polynomial, root, error] :
       {Search{{1e-20, 1.0, -1.25}, 0.8, 1e-15}, Search{{1e-60, 0.0, 1e-10, -1.0}, 1e-10, 1e-24},
        Search{{2.7812077813809178e-197, 1.1217003537489976e-92, -8.3479354679376937e-16,
                4.2588750532097565e-71, 5.7844852586960428e-91, 3.7263156780345552e-41},
               1.1217003537489976e-92 / 8.3479354679376937e-16,
               1e-90},
        Search{{1e-302, 0.0, 1e-35, -1.0}, 1e-35, 1e-50},
        Search{{2.8e-94, 8.3e-82, 0.0, 0.0, 0.0, 0.0, 0.0, 6e-13, -3e-6}, 2e-7, 1e-21}}) {
    Counters counters;
    const auto found = first_root(rounded(polynomial), 1.0, counters);
    ASSERT_TRUE(found) << root;
    EXPECT_NEAR(found->u, root, error);
    EXPECT_LE(counters.root_iterations, 64) << root;
  }
}

// The way back of a mass to the stop it has just left, a bent parabola: most searches of a chatter
// are of this kind. What is clear of zero takes no step at all.
TEST(FirstRoot, TakesFewSteps) {
  Counters counters;
  int found = 0;
  for (unsigned seed = 1; seed <= 2000; ++seed) {
    const double bend = 0.6 * std::abs(std::sin(seed));
    Coefficients gap{0.0L, 0.8L, -1.0L};
    for (std::size_t n = 3; n <= 11; ++n)
      gap.push_back(std::pow(bend, static_cast<double>(n - 2)) *
                    std::cos(seed * static_cast<double>(n)) / 3.0);
    found += first_root(rounded(gap), 1.0, counters).has_value();
  }
  EXPECT_GT(found, 1000);
  EXPECT_LT(counters.root_iterations, 2.5 * found);

  counters = {};
  EXPECT_FALSE(first_root(rounded({1.0L, -0.3L, 0.2L, -0.6L}), 1.0, counters));
  EXPECT_EQ(counters.roots_dismissed, 1);
  EXPECT_EQ(counters.root_iterations, 0);
}

}  // namespace
