// The first root of a polynomial on (0, 1]: never passed over, accurate up to rounding, and found
// in few steps. The first event of a step.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <random>
#include <vector>

#include "simulation/flight/first_event.hpp"

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

// Sum of the moduli of the terms: the scale of the rounding of a value of p.
double size_of(const Polynomial &p, double u) {
  double size = 0.0;
  for (int n = p.order; n >= 0; --n)
    size = size * u + std::abs(p.coefficient[static_cast<std::size_t>(n)]);
  return size;
}

std::optional<double> first(const Polynomial &p, double limit = 1.0) {
  Counters counters;
  return first_root(p, limit, counters);
}

struct Allowed {
  double roundings;             // of the terms, in the value at the root
  long long steps;              // of the search
  long double smallest, ratio;  // of the grid
};

// A reported root is a root up to rounding, or up to the underflow of the products of its terms. No
// value before it is negative, on a grid in extended precision. Without a reported root, no value
// up to 1 is negative. Returns whether a root was reported.
bool expect_neither_missed_nor_passed(const Polynomial &p, const Allowed &allowed) {
  Counters counters;
  const auto root = first_root(p, 1.0, counters);
  const double end = root ? *root : 1.0;
  EXPECT_LE(counters.root_iterations, allowed.steps);
  if (root) {
    const double rounding = allowed.roundings * epsilon * size_of(p, end);
    EXPECT_LE(std::abs(value_of(p, end)), rounding + 1e-308L);
  }
  for (long double u = allowed.smallest; u < end * (1.0L - 1e-12L); u *= allowed.ratio)
    EXPECT_GE(value_of(p, u), 0.0L) << "at " << u << " of " << end;
  return root.has_value();
}

// Roots on both sides of the interval and in it, and pairs outside it. The steps are no measure: no
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

// A gap and its speed are known exactly and have any size. The other terms are between rounding and
// one. In every fourth polynomial a unit brings all terms next to the largest double.
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
    EXPECT_NEAR(*root, 0.5 - std::sqrt(depth), 2.2e-16 / std::sqrt(depth)) << depth;
  }
  Counters counters;
  const auto touch = first_root(rounded({0.25L, -1.0L, 1.0L}), 1.0, counters);
  ASSERT_TRUE(touch);
  // A step goes at least an eighth of the way, from 0.5 to 1e-8.
  EXPECT_LE(counters.root_iterations, 140);
  // Within sqrt(eps) of the tangency the polynomial is zero up to rounding.
  EXPECT_NEAR(*touch, 0.5, 2e-8);
}

TEST(FirstRoot, AtTheLimitOrAtTheStart) {
  // After a release: u^2 (or u^3) times a line that reaches zero at 1/4. Exact in binary.
  EXPECT_EQ(first(rounded({0.0L, 0.0L, 1.0L, -4.0L})).value(), 0.25);
  EXPECT_EQ(first(rounded({0.0L, 0.0L, 0.0L, 1.0L, -4.0L})).value(), 0.25);
  EXPECT_EQ(first(rounded({1.0L, -1.0L})).value(), 1.0);
  EXPECT_EQ(first(rounded({0.5L, -1.0L}), 0.5).value(), 0.5);
  EXPECT_FALSE(first(rounded({0.5L, -1.0L}), std::nextafter(0.5, 0.0)));
  EXPECT_FALSE(first(rounded({1.0L + 1e-12L, -1.0L})));
  EXPECT_FALSE(first(rounded({0.0L, 0.0L, 0.0L}))) << "what stays at zero never returns to it";
  EXPECT_FALSE(first(rounded({0.0L, 0.0L, 0.0L, 0.0L})));
  EXPECT_EQ(first(rounded({0.0L, -1e-20L, 1.0L})).value(), 0.0) << "leaves through zero";
  EXPECT_EQ(first(rounded({-1.0L, 5.0L})).value(), 0.0);
  EXPECT_FALSE(first(rounded({0.0L, 1e-300L})));
}

// The bound of the fifth derivative up to 1 is far too large near 0, where it allows steps of
// 1e-18.
TEST(FirstRoot, OfASmallPolynomialIsFoundInFewSteps) {
  Counters counters;
  const Polynomial small = rounded({2.8e-94, 8.3e-82, 0.0, 0.0, 0.0, 0.0, 0.0, 6e-13, -3e-6});
  const auto root = first_root(small, 1.0, counters);
  ASSERT_TRUE(root);
  EXPECT_NEAR(*root, 2e-7, 1e-21);
  EXPECT_LE(counters.root_iterations, 64);
}

// A search whose bounds are no numbers must not pass for a search without a root.
TEST(FirstRoot, OutOfTheRangeOfDoublesIsNoNumber) {
  const auto root = first(rounded({1e308L, -1e308L, 1e308L, -1e308L, 1e308L, 1e308L}));
  ASSERT_TRUE(root);
  EXPECT_TRUE(std::isnan(*root));
}

// A search that needs several iterations tells whether it has ended.
TEST(FirstRoot, IsInfiniteWhereTheSearchDoesNotEnd) {
  Counters counters;
  const Polynomial p = rounded({0.26L, -1.0L, 1.0L, 0.0L, -0.2L});
  ASSERT_LT(first_root(p, 1.0, counters).value(), 1.0);
  ASSERT_GE(counters.root_iterations, 2);
  EXPECT_EQ(first_root(p, 1.0, counters, 1), infinity);
}

// 1e-315 (1 - 3 u + u^2): the reciprocal of the slope is not a double.
TEST(FirstRoot, OfCoefficientsBelowTheNormalNumbersIsFound) {
  const auto root = first(rounded({1e-315L, -3e-315L, 1e-315L}));
  ASSERT_TRUE(root);
  EXPECT_NEAR(*root, 0.5 * (3.0 - std::sqrt(5.0)), 1e-8) << "1e-315 has eight digits";
}

// Two free masses come to their stops one after the other. Whichever stop is listed first, only the
// mass that comes first may have an event at that instant.
TEST(FirstEvent, IsTheSameInAnyOrderOfTheStops) {
  const Stop soon{1, Side::upper, 0.1}, later{2, Side::upper, 0.2};
  for (const bool later_first : {false, true}) {
    Scene scene;
    scene.mass = scene.stiffness = {1.0, 1.0};
    scene.stops = {later_first ? later : soon, later_first ? soon : later};
    const Chain chain(scene);
    const ContactMode mode = build_contact_mode(chain, {0, 0});
    Motion motion;
    motion.mode = &mode;
    clear(chain, motion);
    for (std::size_t i : {0u, 1u}) place(i, 0.0, 1.0, motion);
    find_acceleration(chain, motion);
    std::vector<Start> starts;
    for (const Contact &contact : mode.contacts)
      starts.push_back(contact_start(chain, contact, ExactZeros{}, motion));
    std::vector<Near> near(2);
    Counters counters;
    StepSearch search;
    const Step step{.length = 0.5, .unit = 0.5, .u_max = 1.0, .order = 19};
    const FlightEnd end = search.find_first_event(chain, motion, step, starts, near, counters);
    ASSERT_TRUE(end.event);
    EXPECT_NEAR(end.tau.hi, 0.1, 1e-3) << "the springs delay it by some 0.1^3";
    EXPECT_EQ(near[later_first], Near::zero);
    EXPECT_EQ(near[!later_first], Near::no);
  }
}

}  // namespace
