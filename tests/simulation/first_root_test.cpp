// The first root of a polynomial on (0, 1]: found, never passed, and relatively accurate after
// deflation.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <complex>
#include <initializer_list>
#include <limits>
#include <optional>
#include <random>
#include <vector>

#include "polynomials.hpp"
#include "simulation/flight/first_root.hpp"

namespace {

using namespace vibro_impact;
using namespace vibro_impact::testing;

constexpr double epsilon = std::numeric_limits<double>::epsilon();

std::optional<Root> first(const Polynomial &p, double limit = 1.0) {
  Counters counters;
  return first_root(p, limit, counters);
}

TEST(FirstRoot, FindsATransversalRootToRounding) {
  for (double at : {1e-6, 0.1, 0.3, 0.9, 0.999}) {
    const Polynomial p = rounded(times({at, -1.0L}, {2.0L, 0.0L, 1.0L}));
    const auto root = first(p);
    ASSERT_TRUE(root);
    // Coefficients rounded at size 2 at most, slope at least 2: two roundings of the root itself
    // at most, since the coefficients of order zero and one dominate.
    EXPECT_NEAR(root->at, at, 4 * epsilon * std::max(at, 0.1));
    EXPECT_NEAR(jet_at(p, 0, root->at).slope, -(2.0 + at * at), 1e-14);
    // What rounding leaves uncertain: that of the terms there over the slope.
    const double noise = 2.0 * epsilon * size_of(p, root->at);
    EXPECT_LE(std::abs(root->at - at), noise / std::abs(root->slope) + epsilon * at);
  }
}

TEST(FirstRoot, FindsAnExactTangency) {
  // (u - a)^2 with exact coefficients: it touches zero and goes no further.
  for (double at : {0.25, 0.5, 0.75}) {
    const auto root = first(rounded({at * at, -2.0L * at, 1.0L}));
    ASSERT_TRUE(root);
    // Within sqrt(eps) of the tangency the polynomial cannot be told from zero.
    EXPECT_NEAR(root->at, at, 2e-8);
  }
}

TEST(FirstRoot, DecidesGrazingOfADipDownTo1e15) {
  // (u - 1/2)^2 + d: rounding of its value is 1.1e-16 (half an epsilon of the sum of its terms, 1).
  for (double missed : {1e-15, 1e-12, 1e-6, 1e-2})
    EXPECT_FALSE(first(rounded({0.25L + missed, -1.0L, 1.0L}))) << missed;
  for (double depth : {1e-15, 1e-12, 1e-6, 1e-2}) {
    const auto root = first(rounded({0.25L - depth, -1.0L, 1.0L}));
    ASSERT_TRUE(root) << depth;
    // The value's rounding over the slope 2 sqrt(depth).
    EXPECT_NEAR(root->at, 0.5 - std::sqrt(depth), 2.2e-16 / std::sqrt(depth)) << depth;
  }
}

TEST(FirstRoot, FindsTheFirstOfTwoCloseRoots) {
  for (double distance : {1e-2, 1e-4, 1e-6}) {
    const long double a = 0.4L, b = 0.4L + distance;
    const Polynomial p = rounded(times(times({-a, 1.0L}, {-b, 1.0L}), {3.0L, 1.0L, -0.5L}));
    const auto root = first(p);
    ASSERT_TRUE(root) << distance;
    // Rounding of coefficients up to 3 over a slope of 3 distance.
    EXPECT_NEAR(root->at, 0.4, 4e-16 / distance) << distance;
    EXPECT_LT(jet_at(p, 0, root->at).slope, 0.0);
  }
}

TEST(FirstRoot, AgreesWithKnownRootsOfRandomPolynomials) {
  std::mt19937 generator(2006);
  std::uniform_real_distribution<double> place(-1.0, 2.0), even(-1.0, 1.0);
  std::uniform_int_distribution<int> some(0, 3);
  int with_root = 0, without = 0;
  double worst = 0.0;
  for (int trial = 0; trial < 20000; ++trial) {
    Coefficients p{1.0L};
    std::vector<double> real;
    const int roots = 1 + some(generator);
    for (int i = 0; i < roots; ++i) {
      real.push_back(place(generator));
      p = times(p, {-static_cast<long double>(real.back()), 1.0L});
    }
    for (int pairs = some(generator); pairs > 0; --pairs) {
      const long double x = place(generator), y = 0.05 + std::abs(even(generator));
      p = times(p, {x * x + y * y, -2.0L * x, 1.0L});
    }
    std::sort(real.begin(), real.end());
    bool apart = true;  // from each other and from the ends, so that rounding cannot decide
    for (std::size_t i = 0; i < real.size(); ++i)
      apart = apart && std::abs(real[i]) > 1e-3 && std::abs(real[i] - 1.0) > 1e-3 &&
              (i == 0 || real[i] - real[i - 1] > 1e-3);
    if (!apart) continue;
    if (p[0] < 0.0L)
      for (long double &c : p) c = -c;
    const Polynomial polynomial = rounded(p);
    const auto expected = std::find_if(real.begin(), real.end(), [](double r) { return r > 0.0; });
    const auto root = first(polynomial);
    if (expected == real.end() || *expected > 1.0) {
      EXPECT_FALSE(root) << "trial " << trial;
      ++without;
      continue;
    }
    ASSERT_TRUE(root) << "trial " << trial << ", root " << *expected;
    ++with_root;
    // The root of the polynomial with rounded coefficients.
    long double exact = *expected;
    for (int i = 0; i < 4; ++i) exact -= value_of(polynomial, exact) / slope_of(polynomial, exact);
    const double error = static_cast<double>(std::abs(root->at - exact));
    const double noise = epsilon * size_of(polynomial, root->at) /
                         static_cast<double>(std::abs(slope_of(polynomial, exact)));
    // Values are known to a few roundings of their terms: half an epsilon of their sum of moduli
    // each in Horner's rule.
    EXPECT_LE(error, 4.0 * noise + epsilon * root->at) << "trial " << trial;
    worst = std::max(worst, error / (noise + epsilon * root->at));
  }
  EXPECT_GT(with_root, 5000);
  EXPECT_GT(without, 2000);
  RecordProperty("worst_error_in_units_of_noise", fmt::format("{:.3g}", worst));
}

TEST(FirstRoot, AgreesWithTheCompanionMatrixOnRandomCoefficients) {
  std::mt19937 generator(137);
  std::uniform_real_distribution<double> even(-1.0, 1.0);
  int compared = 0, found = 0;
  for (int trial = 0; trial < 6000; ++trial) {
    const int order = 2 + trial % 11;
    Coefficients p{std::abs(even(generator)) * std::pow(10.0, -(trial % 7))};
    for (int n = 1; n <= order; ++n) p.push_back(even(generator));
    Eigen::MatrixXd companion = Eigen::MatrixXd::Zero(order, order);
    for (int n = 0; n < order; ++n) {
      if (n + 1 < order) companion(n + 1, n) = 1.0;
      companion(n, order - 1) =
          static_cast<double>(-p[static_cast<std::size_t>(n)] / p[static_cast<std::size_t>(order)]);
    }
    const Eigen::VectorXcd roots = companion.eigenvalues();
    std::optional<double> expected;
    bool clear = true;  // of nearly double roots and of roots at the ends
    for (const std::complex<double> &z : roots) {
      const bool real = std::abs(z.imag()) < 1e-9;
      if (z.real() > -1e-3 && z.real() < 1.0 + 1e-3 && !real && std::abs(z.imag()) < 1e-4)
        clear = false;
      if (!real) continue;
      if (std::abs(z.real() - 1.0) < 1e-6) clear = false;
      if (z.real() > 0.0 && z.real() <= 1.0 && (!expected || z.real() < *expected))
        expected = z.real();
      for (const std::complex<double> &other : roots)
        if (&other != &z && std::abs(other - z) < 1e-4) clear = false;
    }
    if (!clear) continue;
    ++compared;
    const auto root = first(rounded(p));
    ASSERT_EQ(root.has_value(), expected.has_value()) << "trial " << trial;
    if (!root) continue;
    ++found;
    // Eigenvalues of a companion matrix with entries up to 1e3, roots 1e-4 apart: about 1e-9.
    EXPECT_NEAR(root->at, *expected, 1e-9) << "trial " << trial;
  }
  EXPECT_GT(compared, 4000);
  EXPECT_GT(found, 1000);
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
    EXPECT_NEAR(root->at, static_cast<double>(exact), 4 * epsilon * root->at) << v;
    const auto there = jet_at(p, 0, root->at);
    EXPECT_NEAR(there.slope, static_cast<double>(slope_of(p, exact)), 8 * epsilon * v) << v;
    EXPECT_LT(std::abs(there.value), 8 * epsilon * v * root->at) << v;
  }
}

TEST(FirstRoot, DeflatesTwoAndThreeZeros) {
  // After a release: u^2 (or u^3) times a line that reaches zero at 1/4. Exact in binary.
  for (int zeros : {2, 3}) {
    Coefficients coefficients(static_cast<std::size_t>(zeros), 0.0L);
    coefficients.push_back(1.0L);
    coefficients.push_back(-4.0L);
    const Polynomial p = rounded(coefficients);
    const auto root = first(p);
    ASSERT_TRUE(root);
    EXPECT_EQ(root->at, 0.25);
    EXPECT_EQ(jet_at(p, 0, root->at).slope, -4.0 * std::pow(0.25, zeros));
  }
}

TEST(FirstRoot, RootAtTheLimitCounts) {
  EXPECT_EQ(first(rounded({1.0L, -1.0L})).value().at, 1.0);
  EXPECT_EQ(first(rounded({0.5L, -1.0L}), 0.5).value().at, 0.5);
  EXPECT_FALSE(first(rounded({0.5L, -1.0L}), std::nextafter(0.5, 0.0)));
  EXPECT_FALSE(first(rounded({1.0L + 1e-12L, -1.0L})));
}

TEST(FirstRoot, ZeroAndNegativePolynomials) {
  EXPECT_FALSE(first(rounded({0.0L, 0.0L, 0.0L}))) << "what stays at zero never returns to it";
  EXPECT_FALSE(first(rounded({0.0L, 0.0L, 0.0L, 0.0L})));
  EXPECT_EQ(first(rounded({0.0L, -1e-20L, 1.0L})).value().at, 0.0) << "leaves through zero";
  EXPECT_EQ(first(rounded({-1.0L, 5.0L})).value().at, 0.0);
  EXPECT_FALSE(first(rounded({0.0L, 1e-300L})));
}

TEST(FirstRoot, ADipPassedDoesNotHideTheNext) {
  for (double second : {0.35, 0.4, 0.6, 0.9}) {
    const Coefficients clear = {0.09L + 1e-9L, -0.6L, 1.0L};  // (u - 0.3)^2 + 1e-9
    const long double at = second;
    const Coefficients crossed = {at * at - 1e-8L, -2.0L * at, 1.0L};  // roots at 1e-4 about it
    const auto root = first(rounded(times(clear, crossed)));
    ASSERT_TRUE(root) << second;
    // The rounding of the coefficients and of their sum, of the size of the terms there, over the
    // slope, 2e-4 (second - 0.3)^2.
    const double size = (0.3 + second) * (0.3 + second) * (4.0 * second * second);
    const double slope = 2e-4 * (second - 0.3) * (second - 0.3);
    const double rounding = 2.0 * std::numeric_limits<double>::epsilon() * size;
    EXPECT_NEAR(root->at, second - 1e-4, rounding / slope) << second;
  }
}

// The steps of order five start where the root ahead is certain to be the only one near, which the
// moduli of the coefficients tell; here their signs hide a wiggle.
TEST(FirstRoot, WigglyPolynomialsGiveTheFirstRoot) {
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> even(-1.0, 1.0);
  int found = 0;
  for (int trial = 0; trial < 4000; ++trial) {
    Coefficients p{0.02 + 0.1 * std::abs(even(generator)), -0.1 * std::abs(even(generator))};
    double size = 1.0;
    for (int n = 2; n <= 12; ++n) p.push_back(size *= 1.8 * even(generator) + 0.2);
    const Polynomial polynomial = rounded(p);
    // Of 20,000 samples the first that is not positive.
    std::optional<double> sampled;
    for (int i = 1; i <= 20000 && !sampled; ++i)
      if (value_of(polynomial, i / 20000.0L) <= 0.0L) sampled = i / 20000.0;
    const auto root = first(polynomial);
    if (!sampled) continue;  // a root may still hide between two samples
    ASSERT_TRUE(root) << "trial " << trial;
    EXPECT_LE(root->at, *sampled) << "trial " << trial;
    EXPECT_LE(std::abs(static_cast<double>(value_of(polynomial, root->at))),
              8.0 * epsilon * size_of(polynomial, root->at))
        << "trial " << trial;
    EXPECT_NEAR(root->slope, static_cast<double>(slope_of(polynomial, root->at)), 1e-12) << trial;
    ++found;
  }
  EXPECT_GT(found, 1000);
}

}  // namespace
