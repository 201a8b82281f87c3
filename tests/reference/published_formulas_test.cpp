// The formulas among the published results: that the table has their values, and that the library
// follows them where they say more than one number.
#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/special_functions/airy.hpp>

#include "figures/published.hpp"

namespace {

using namespace vibro_impact;
using namespace vibro_impact::published;

// Budd and Dux, x'' + x = cos(omega t), x <= stop: their closed form of the orbit with one impact
// in n forcing periods, and the speed at which it doubles its period as the stop is moved.
struct BuddDux {
  double omega, r, cosine, gamma, r_minus, cs;

  explicit BuddDux(const Parameters &p) : omega(p.at("omega")), r(p.at("r")) {
    const double period = p.at("n") * Clock(omega).period, sine = std::sin(period);
    cosine = std::cos(period);
    gamma = 1.0 / (1.0 - omega * omega);
    r_minus = (1.0 - r) / omega;
    cs = std::abs(sine) < 1e-14 ? 0.0 : sine * (1.0 + r) / (1.0 - cosine);
  }
  // The faster (branch 1) or the slower (-1) of the two orbits at a stop.
  double speed(double stop, double branch) const {
    const double square = cs * cs + r_minus * r_minus;
    const double discriminant =
        gamma * gamma * cs * cs - (stop * stop - gamma * gamma) * r_minus * r_minus;
    return 2.0 * (branch * std::sqrt(discriminant) - cs * stop) / square;
  }
  double doubling_speed() const {
    const double sine = cs * (1.0 - cosine) / (1.0 + r), c2 = cs * cs;
    const double b =
        4.0 * r * cosine - 2.0 * (1.0 + r * r) + (omega * omega - 1.0) * c2 * (1.0 - cosine);
    const double s = (1.0 + r) * omega * sine;
    const double square =
        b * b + s * s * (omega * omega * (c2 + r_minus * r_minus) - 2.0 * b / (1.0 - cosine));
    return std::abs(2.0 * s * omega * gamma) / std::sqrt(square);
  }
};

// Time of rest of a ball on the ground: each flight lasts 2 v / g.
double rest_of_ball(double impact, double speed, double g, double r) {
  return impact + 2.0 * r * speed / (g * (1.0 - r));
}

double chatter_limit(const Parameters &p) {
  const double g = -p.at("force") / p.at("mass"), r = p.at("r");
  if (p.at("k") == 0.0) {
    const double v = p.at("velocity"), speed = std::sqrt(v * v + 2.0 * g * p.at("height"));
    return rest_of_ball((v + speed) / g, speed, g, r);
  }
  // About an equilibrium d behind the stop: a flight that starts with v lasts (2/w) atan(v/(w d)).
  const double w = std::sqrt(p.at("k") / p.at("mass")), d = g / (w * w), top = p.at("height") + d;
  double time = std::acos(d / top) / w;
  for (double v = r * w * std::sqrt(top * top - d * d); v > 1e-25; v *= r)
    time += 2.0 / w * std::atan(v / (w * d));
  return time;
}

// Off the ceiling twice; after the fourth impact the ball does not reach it again.
double chatter_limit_below_a_ceiling(const Parameters &p) {
  const double g = -p.at("force") / p.at("mass"), r = p.at("r");
  double x = p.at("height"), v = p.at("velocity"), time = 0.0;
  while (v * v > 2.0 * g * (p.at("ceiling") - x)) {
    const double up = std::sqrt(v * v - 2.0 * g * (p.at("ceiling") - x));
    const double down = std::sqrt(r * r * up * up + 2.0 * g * p.at("ceiling"));
    time += (v - up) / g + (down - r * up) / g;
    x = 0.0;
    v = r * down;
  }
  return rest_of_ball(time, v / r, g, r);
}

double formula(const Result &row) {
  const Parameters &p = row.parameters;
  if (row.quantity == "impact_speed") return BuddDux(p).speed(p.at("stop"), p.at("branch"));
  if (row.quantity == "doubling_speed") return BuddDux(p).doubling_speed();
  if (row.quantity == "first_order_chatter_limit")
    return 2.0 * p.at("speed") / ((1.0 - p.at("stop")) * (1.0 - p.at("r")));
  if (row.quantity == "release_time") return std::acos(p.at("stop")) / p.at("omega");
  if (row.quantity == "grazing_amplitude")
    return std::hypot(1.0 - p.at("omega") * p.at("omega"), p.at("c") * p.at("omega"));
  if (row.quantity == "chatter_limit")
    return p.contains("ceiling") ? chatter_limit_below_a_ceiling(p) : chatter_limit(p);
  if (row.quantity == "bar_contact_time") return 2.0 / std::sqrt(elasticity / density);
  if (row.quantity == "bar_rate") return 2.0 / 3.0;
  throw std::runtime_error(row.quantity + ": no formula");
}

// 15 digits are printed.
TEST(Formulas, HaveTheValuesOfTheTable) {
  int formulas = 0;
  for (const Result &row : results(REFERENCE_DIR)) {
    if (row.kind != "formula") continue;
    EXPECT_NEAR(formula(row), row.value, 4e-15 * std::max(1.0, std::abs(row.value))) << row.id;
    ++formulas;
  }
  EXPECT_GE(formulas, 40);
}

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
