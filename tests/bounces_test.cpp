// The impacts of a chatter, followed over short flights, against impact by impact in closed form;
// what they predict of the limit.
#include <gtest/gtest.h>

#include "followed_chatter.hpp"

namespace {

using namespace vibro_impact;
using vibro_impact::testing::dynamic, vibro_impact::testing::Followed,
    vibro_impact::testing::Pressed;

// Damped and not, with modes split in two decays, with a mode in resonance.
const std::vector<std::pair<double, double>> kinds{
    {0.0, 0.2}, {0.1, 0.2}, {2.0, 0.2}, {30.0, 0.2}, {0.0, 1.0}};

double resonant_frequency() {
  const Pressed any(0.0, 0.2, 0.7);
  return std::sqrt(any.mode.lambda(1)) * (1.0 + 1e-9);
}

double largest_difference(const State<dynamic> &a, const State<dynamic> &b) {
  return std::max((a.value - b.value).abs().maxCoeff(), (a.slope - b.slope).abs().maxCoeff());
}

// 2e-14: the rounding of a dozen closed forms of numbers of order one.
TEST(Bounces, AgreeWithImpactByImpactInClosedForm) {
  for (auto [beta, omega] : kinds) {
    if (beta == 0.0 && omega > 0.5) omega = resonant_frequency();
    Pressed at(beta, omega, 0.7), slow = at;
    ASSERT_EQ(at.mode.any_resonant, omega > 0.5);
    ASSERT_EQ(at.mode.any_decay, beta >= 2.0);
    slow.state.mode = &slow.mode;
    Followed followed(at);
    ASSERT_TRUE(followed.started);
    double before = 0.0;
    int impacts = 0;
    for (; impacts < 12 && followed.find(); ++impacts) {
      EXPECT_TRUE(followed.bounces.near.empty());  // the stop of mass 3 is far: not looked at
      followed.apply();
      slow.fly(followed.bounces.time - before);
      before = followed.bounces.time;
      const Reading<dynamic> &gap = slow.mode.open[0].gap;
      EXPECT_NEAR(gap(slow.state.value, slow.state.slope), 0.0, 2e-15) << beta;
      const double speed = (gap.on_value * slow.state.slope).sum();
      EXPECT_NEAR(speed, followed.closing[0], 2e-15) << beta << " impact " << impacts;
      apply_impact(slow.state, slow.scene, slow.mode.open[0], followed.closing[0]);
      EXPECT_LT(largest_difference(at.state, slow.state), 2e-14) << beta << " impact " << impacts;
    }
    refresh_stops(followed.bounces, at.state);
    EXPECT_NEAR(at.state.stops[1].gap, slow.mode.open[1].gap(slow.state.value, slow.state.slope),
                2e-14);
    EXPECT_EQ(impacts, 12) << beta;
  }
}

// The state at the limit, from a dozen impacts, against sixty more and what is left of them. 1e-9:
// the speed left then.
TEST(Bounces, TheLimitAgreesWithResolvingWhatIsLeft) {
  for (const double beta : {0.0, 0.1, 0.5}) {
    Pressed at(beta, 0.3, 0.6);
    Followed followed(at);
    ASSERT_EQ(followed.go_on(10), 10);
    const auto limit = extrapolate(followed.table, at.mode.fastest, 1e-12);
    ASSERT_TRUE(limit);
    Tail<dynamic> tail;
    EXPECT_LT(find_tail(followed.bounces, at.state, followed.table, *limit, tail, at.counters),
              1e-11);
    EXPECT_TRUE(undisturbed(followed.bounces, at.state, tail, at.counters));
    State<dynamic> there = at.state, before;
    const double end = followed.bounces.time + limit->left;
    move_to_limit(followed.bounces, tail, at.scene,
                  later(at.state.now, limit->left, Clock(at.scene.omega)), there, before,
                  at.counters);
    EXPECT_EQ(before.value(0), at.state.value(0));
    EXPECT_EQ(there.stops[0].gap, 0.0);
    EXPECT_EQ(there.stops[0].speed, 0.0);
    followed.go_on(40);
    EXPECT_LT(at.state.stops[0].speed, 1e-9);
    EXPECT_NEAR(end, followed.bounces.time, 1e-8);
    at.fly(end - followed.bounces.time);  // the impulse of the rest is below rounding
    EXPECT_LT(largest_difference(there, at.state), 1e-9);
  }
}

// What is left after an impact is the flight to the next one and what is left after that: the
// residual of the series is O(x^5), 32 times less for half of x, whatever the gap and the response.
TEST(ChatterSeries, AddsUpFromImpactToImpact) {
  for (const double r : {0.1, 0.5, 0.7, 0.9})
    for (unsigned seed = 1; seed <= 50; ++seed) {
      const auto any = [seed, r](int k) {
        return 0.3 * (1 - r) * (1.2 + std::sin(seed * 1.7 + 3.1 * k));
      };
      const Response response{any(1), any(2), any(3)};
      ChatterSeries series;
      series.set(r, response);
      const auto time_left = [&](const std::array<long double, 6> &c) {  // c1 t + c2 t^2 + ...
        const Shape shape{static_cast<double>(c[3] / c[2]), static_cast<double>(c[4] / c[2]),
                          static_cast<double>(c[5] / c[2])};
        const long double x = -c[1] / c[2];
        return x / (1 - static_cast<long double>(r)) -
               x * x * (shape.e - r * response.second) / ((1 - r) * (1 - r)) +
               x * x * series.higher_orders(static_cast<double>(x), shape);
      };
      const auto residual = [&](long double x) {
        const std::array<long double, 6> c{0, x, -1, -any(4), -any(5), -any(6)};
        long double t = x;
        for (int k = 0; k < 60; ++k) t = -(c[1] + t * t * (c[3] + t * (c[4] + t * c[5]))) / c[2];
        std::array<long double, 6> next{};
        for (std::size_t n = 1; n < 6; ++n)
          for (std::size_t m = n; m < 6; ++m)
            next[n] += detail::binomial[n][m] * c[m] * std::pow(t, static_cast<int>(m - n));
        const long double jump = -(1 + static_cast<long double>(r)) * next[1];
        next[1] += jump;
        next[2] += jump * response.second;
        next[3] += jump * response.third;
        next[4] += jump * response.fourth;
        return time_left(c) - t - time_left(next);
      };
      EXPECT_NEAR(static_cast<double>(residual(2e-3L) / residual(1e-3L)), 32.0, 1.0)
          << r << " " << seed;
    }
}

// What an impact predicts of the limit is wrong by O(x^5), and so falls by r^5 from one impact to
// the next: within 15 percent where it is between rounding and the terms of higher order.
TEST(ChatterSeries, PredictsTheLimitToFourthOrder) {
  for (const double restitution : {0.5, 0.7})
    for (const double beta : {0.0, 0.1, 0.5}) {
      Pressed at(beta, 0.3, restitution);
      Followed followed(at);
      std::vector<double> limits{predict_limit(followed.bounces).limit};
      for (int k = 0; k < 24; ++k) {
        ASSERT_EQ(followed.go_on(1), 1) << k;
        limits.push_back(predict_limit(followed.bounces).limit);
      }
      int compared = 0;
      const double fall = std::pow(restitution, 5);
      for (std::size_t k = 0; k + 1 < limits.size(); ++k) {
        const double error = limits[k] - limits.back(), next = limits[k + 1] - limits.back();
        if (std::abs(error) > 1e-7 || std::abs(next) < 2e-13) continue;
        EXPECT_NEAR(next / error, fall, 0.15 * fall)
            << restitution << " " << beta << " impact " << k;
        ++compared;
      }
      EXPECT_GE(compared, 2) << restitution << " " << beta;
    }
}

// The moments of all impacts after one, likewise: sums over sixty impacts are wrong by nothing, the
// series of the moment of order one by O(T^3) of it, that of order two by O(T^2).
TEST(ChatterSeries, PredictsTheMoments) {
  for (const double restitution : {0.5, 0.7}) {
    Pressed at(0.1, 0.3, restitution);
    Followed followed(at);
    std::vector<ChatterNode> nodes{predict_limit(followed.bounces)};
    for (int k = 0; k < 60 && followed.go_on(1) == 1; ++k)
      nodes.push_back(predict_limit(followed.bounces));
    const auto &[times, jumps] = std::tie(followed.bounces.times, followed.bounces.jumps);
    const double end = nodes.back().limit;
    const auto errors = [&](std::size_t i) {
      const double left = end - times[i];
      std::array<double, 2> sums{};
      for (std::size_t k = i + 1; k < times.size(); ++k)
        for (std::size_t n = 0; n < 2; ++n)
          sums[n] +=
              jumps[k] / jumps[i] * std::pow((end - times[k]) / left, static_cast<double>(n + 1));
      const auto rise = followed.bounces.series.rise_of_moments(left, nodes[i].shape);
      const auto &moments = followed.bounces.series.of.moments;
      for (std::size_t n = 0; n < 2; ++n)
        sums[n] = std::abs(sums[n] / moments[n + 1] - 1.0 - rise[n]);
      return sums;
    };
    const std::size_t at_impact = restitution == 0.5 ? 4 : 8;
    const auto before = errors(at_impact), after = errors(at_impact + 1);
    EXPECT_NEAR(after[0] / before[0], std::pow(restitution, 3), 0.1) << restitution;
    EXPECT_NEAR(after[1] / before[1], std::pow(restitution, 2), 0.1) << restitution;
  }
}

// A flight that no expansion reaches to the end of is none of a chatter's.
TEST(Bounces, AreNotFollowedOverLongFlights) {
  Pressed at(0.1, 0.3, 0.9);
  at.state.mode = &at.mode;
  for (const double reach : {0.5, 1.0, 1.1, 2.0, 20.0}) {
    Bounces<dynamic> bounces;
    ASSERT_TRUE(follow(bounces, at.state, at.scene, {0}, reach / at.mode.fastest, at.counters));
    EXPECT_EQ(find_next(bounces, at.state, at.counters), reach <= 1.0) << reach;
    EXPECT_LE(bounces.path.span * bounces.path.rate, std::max(max_reach, 1.2 * reach));
  }
}

}  // namespace
