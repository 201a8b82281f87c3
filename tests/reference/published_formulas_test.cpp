// The formulas among the published results that say more than the numbers of the table, which `make
// check` judges: how the library comes near the limits they are.
#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/special_functions/airy.hpp>

#include "figures/published.hpp"

namespace {

using namespace vibro_impact;
using namespace vibro_impact::published;

// The lumped bar: the contact outlasts 2 L / c by the width of the front, dispersed by the lattice
// into an Airy function: the force returns to zero where the front has brought half its step, that
// is at xi with int_0^xi Ai(-s) ds = 1/6, and
//   T_N / T = 1 + xi / (2 4^(1/3)) N^(-2/3) + ...
TEST(Bar, ContactTimeFallsToTheLimitAsTheDispersedFrontSays) {
  const auto step = [](double xi) {
    return boost::math::quadrature::gauss_kronrod<double, 31>::integrate(
               [](double s) { return boost::math::airy_ai(-s); }, 0.0, xi) -
           1.0 / 6.0;
  };
  const double constant = zero(step, 0.0, 1.0).value / (2.0 * std::cbrt(4.0));
  EXPECT_NEAR(constant, 0.1290168, 1e-7);
  const double limit = 2.0 / std::sqrt(elasticity / density);
  std::vector<double> scaled;
  for (int n : {25, 50, 100, 200, 400}) {
    const double excess = contact_time(n) / limit - 1.0;
    EXPECT_GT(excess, 0.0);
    scaled.push_back(excess * std::pow(n, 2.0 / 3.0));
    // What is left is of the next order, N^(-2/3) (the constant of it measured: 0.073).
    EXPECT_NEAR(scaled.back(), constant, 0.08 * std::pow(n, -2.0 / 3.0)) << n;
  }
  EXPECT_TRUE(std::is_sorted(scaled.begin(), scaled.end()));
}

// Its wall takes twice the momentum, but for what stays in vibration.
TEST(Bar, ReboundsWithAllButAHundredthOfItsMomentum) {
  const double momentum = 0.1 * density * section;
  const double impulse = impulse_of_the_wall(bar(100, 100));
  EXPECT_LT(impulse, 2.0 * momentum);
  EXPECT_GT(impulse, 1.98 * momentum);
}

// Leading order of a chatter: what is left falls with the cube of the speed.
TEST(Formulas, TheChatterLimitOfBuddAndDuxIsOfLeadingOrder) {
  const auto excess = [](double speed) {
    const Parameters p{{"omega", 2.0}, {"r", 0.5}, {"stop", 0.0}, {"speed", speed}};
    return quantities().at("first_order_chatter_limit")(p) - 4.0 * speed;
  };
  // The least is 2.7e-8 of a time of 4e-3, known to 1e-16 or so.
  EXPECT_NEAR(excess(2e-3) / excess(1e-3), 8.0, 1e-3);
}

}  // namespace
