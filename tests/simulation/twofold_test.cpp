// Sums and products of twice the precision are exact, as the compiler has built them.
#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>

#include "simulation/chain/pair.hpp"
#include "tests/support/random_scenes.hpp"

namespace {

using vibro_impact::detail::exact_product;
using vibro_impact::detail::exact_sum;
using vibro_impact::detail::Twofold;
using Quad = boost::multiprecision::cpp_bin_float_quad;

Quad sum_of(const Twofold<double> &sum) {
  return Quad(sum.value) + Quad(sum.low);
}

TEST(Twofold, SumsAndProductsAreExact) {
  vibro_impact::testing::Draw draw{std::mt19937(1)};
  for (int k = 0; k < 100'000; ++k) {
    const double a = draw.uniform(-1.0, 1.0) * draw.spread(1e-8, 1e8) + draw.uniform(-1e-9, 1e-9),
                 b = draw.uniform(-1.0, 1.0) * draw.spread(1e-8, 1e8) + draw.uniform(-1e-9, 1e-9);
    const Twofold<double> sum = exact_sum(a, b), product = exact_product(a, b);
    EXPECT_EQ(sum.value, a + b);
    EXPECT_EQ(sum_of(sum), Quad(a) + Quad(b));
    EXPECT_EQ(product.value, a * b);
    // The product of two low parts of 27 bits, and the sums of the parts, round 2^-52 of the low
    // part.
    const Quad exact = Quad(a) * Quad(b);
    EXPECT_LE(abs(sum_of(product) - exact), Quad(0x1p-103) * abs(exact));
  }
  // Products that Veltkamp's splitting would carry out of range.
  EXPECT_EQ(exact_product(1e305, 1.0).low, 0.0);
}

}  // namespace
