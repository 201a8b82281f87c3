// Numbers of twice the precision against 50 digits: sums and products to 2^-102 of the sum of the
// moduli of their terms, quotients and functions to ten times that.
#include "simulation/chain/twofold.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <random>

#include "reference/scenes/paper_scenes.hpp"
#include "simulation/chain/motion.hpp"

namespace {

using vibro_impact::detail::Real;
using Digits = boost::multiprecision::cpp_bin_float_50;

Digits digits(const Real &x) {
  return Digits(x.hi) + Digits(x.lo);
}

static_assert(16.0 * vibro_impact::detail::twofold_unit == 0x1p-102);

// The distance of a number from the exact one, in units of 2^-102 of the size of its terms.
double error(const Real &computed, const Digits &exact, const Digits &size) {
  return static_cast<double>(abs(digits(computed) - exact) / size) * 0x1p102;
}

TEST(Twofold, HasTheErrorsThatItsHeaderSays) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (int k = 0; k < 20000; ++k) {
    const double size = std::exp2(std::round(40.0 * uniform(random)));
    const Real a = Real(uniform(random)) + 0x1p-53 * uniform(random),
               b = size * (Real(uniform(random)) + 0x1p-53 * uniform(random));
    const Digits x = digits(a), y = digits(b);
    SCOPED_TRACE(k);
    ASSERT_LE(error(a + b, x + y, abs(x) + abs(y)), 1.0);
    ASSERT_LE(error(a * b, x * y, abs(x * y)), 1.0);
    ASSERT_LE(error(a / b, x / y, abs(x / y)), 10.0);
    ASSERT_LE(error(sqrt(abs(b)), sqrt(abs(y)), sqrt(abs(y))), 10.0);
    // exp and the turn of a large number have the rounding of the number itself.
    const Real c = 560.0 * a;  // beyond, the low part of exp underflows
    const Digits z = digits(c), most = 1 + abs(z);
    ASSERT_LE(error(exp(c), exp(z), most * exp(z)), 10.0);
    Real sine, cosine;
    sincos(c, sine, cosine);
    ASSERT_LE(error(sine, sin(z), most), 10.0);
    ASSERT_LE(error(cosine, cos(z), most), 10.0);
    // The sine of a small angle keeps its digits.
    const Real small = 0x1p-40 * a;
    sincos(small, sine, cosine);
    ASSERT_LE(error(sine, sin(digits(small)), abs(digits(small))), 10.0);
  }
}

// e^(i Omega t) is carried on by steps, each of which rounds its change of second order, w^2 / 2
// with w = Omega tau. Fifty of these roundings are allowed, whatever the number of steps.
TEST(Turn, CarriedOnByStepsIsThatOfThePhase) {
  using namespace vibro_impact::detail;
  const vibro_impact::Scene scene = vibro_impact::paper::figure2();
  const Chain chain(scene);
  for (const double tau : {0.3, 0.5, 1.1}) {
    Motion motion;
    double largest = 0.0;
    for (int step = 0; step < 20000; ++step) {
      pass_time(chain, tau, motion);
      Motion anew = motion;
      set_turn(chain, anew);
      const Turn &exact = anew.turn;
      largest = std::max({largest, std::abs(rounded(motion.turn.cosine - exact.cosine)),
                          std::abs(rounded(motion.turn.sine - exact.sine))});
    }
    const double w = scene.omega * tau;
    EXPECT_LE(largest, 50.0 * 0x1p-53 * 0.5 * w * w) << tau;
  }
}

}  // namespace
