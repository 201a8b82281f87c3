// The impacts of a chatter followed on the gaps alone, against impact by impact in closed form.
#include <gtest/gtest.h>

#include "vibro_impact/chatter_limit.hpp"
#include "vibro_impact/next_bounce.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace {

using namespace vibro_impact;
constexpr int dynamic = Eigen::Dynamic;

TEST(Recentre, MovesAndScalesAPolynomial) {
  for (const int order : {3, 7, 15, 31}) {
    Polynomial p;
    for (int n = 0; n <= order; ++n) p.coefficient[static_cast<std::size_t>(n)] = 1.0 / (n + 1);
    end_at(p, order);
    Polynomial moved;
    const double at = 0.75, scale = 0.5;
    detail::Powers powers_of_at{}, powers_of_scale{};
    detail::set_powers(powers_of_at, at, order);
    detail::set_powers(powers_of_scale, scale, order);
    recentre(p, order, powers_of_at, powers_of_scale, moved);
    for (const double u : {0.0, 0.3, 1.0, 2.0}) {
      const double old = evaluate(p, 0, at + at * scale * u).value;
      EXPECT_NEAR(evaluate(moved, 0, u).value, old, 4e-16 * order * std::abs(old)) << order;
    }
  }
}

// 1e-15: the fifth power of the shift.
TEST(Shift, MovesAPolynomialABit) {
  Polynomial p;
  for (std::size_t n = 0; n < 12; ++n) p.coefficient[n] = std::cos(static_cast<double>(n));
  end_at(p, 11);
  for (const double d : {3e-4, -4e-4, 0.0}) {
    Polynomial moved = p;
    shift(moved, d);
    for (const double u : {0.0, 0.3, 1.0})
      EXPECT_NEAR(evaluate(moved, 0, u).value, evaluate(p, 0, u + d).value, 1e-14) << d << " " << u;
  }
}

// Three masses of which the second has just left its stop and is pressed back by its neighbours.
struct Pressed {
  Scene scene;
  ContactMode<dynamic> mode;
  State<dynamic> state;
  Counters counters;

  double speed;

  Pressed(double beta, double omega, double restitution) : speed(beta > 10.0 ? 1e-3 : 0.06) {
    scene.mass = {1.0, 0.8, 1.3};
    scene.stiffness = {1.0, 1.2, 0.9};
    scene.beta = beta;
    scene.amplitude = {0.3, 0.0, 0.2};
    scene.omega = omega;
    scene.restitution = restitution;
    scene.stops = {{2, Side::upper, 0.1}, {3, Side::upper, 5.0}};
    mode = build_contact_mode<dynamic>(scene, Held(3, 0));
    MotionState motion = start_of(scene);
    motion.displacement << 0.7, 0.1, 0.6;
    motion.velocity << 0.05, -speed, -0.04;
    motion.instant.phase = 0.3;
    state.now = motion.instant;
    set_lanes(state, scene, mode, motion);
    state.stops = {{0.0, speed, 1, speed}, {4.4, 0.04, 0, 0.0}};
  }
  double flight() const {
    return 2.0 * speed * scene.mass[1] / mode.open[0].press(state.value, state.slope);
  }
  // In closed form and in the lanes.
  void fly(double tau) {
    const State<dynamic> from = state;
    flow(mode, scene, from.value, from.slope, tau, state.value, state.slope);
    state.now.phase += tau;
    set_forcing(state, scene);
  }
};

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
TEST(Bounces, AgreeWithImpactByImpactInTheLanes) {
  for (auto [beta, omega] : kinds) {
    if (beta == 0.0 && omega > 0.5) omega = resonant_frequency();
    Pressed at(beta, omega, 0.7), slow = at;
    ASSERT_EQ(at.mode.any_resonant, omega > 0.5);
    ASSERT_EQ(at.mode.any_decay, beta >= 2.0);
    slow.state.mode = &slow.mode;
    at.state.mode = &at.mode;
    Bounces<dynamic> bounces;
    std::vector<double> closing;
    const double covered = std::min(2.5 / at.mode.fastest, 1.25 * at.flight() / 0.3);
    ASSERT_TRUE(follow(bounces, at.state, at.scene, {0}, at.flight(), covered, false, at.counters));
    double before = 0.0;
    int impacts = 0;
    for (; impacts < 12 && find_next(bounces, at.counters); ++impacts) {
      // The stop of mass 3 is far: not watched, with a bound of its gap that the impacts lower.
      ASSERT_EQ(bounces.unwatched_size, 1u);
      const double slack = bounces.unwatched[0].slack;
      bounce(bounces, at.scene, closing);
      EXPECT_LT(bounces.unwatched[0].slack, slack);
      EXPECT_GT(slow.mode.open[1].gap(slow.state.value, slow.state.slope),
                bounces.unwatched[0].slack);
      slow.fly(bounces.time - before);
      before = bounces.time;
      const Reading<dynamic> &gap = slow.mode.open[0].gap;
      EXPECT_NEAR(gap(slow.state.value, slow.state.slope), 0.0, 2e-15) << beta;
      const double speed = (gap.on_value * slow.state.slope).sum();
      EXPECT_NEAR(speed, closing[0], 2e-15) << beta << " impact " << impacts;
      apply_impact(slow.state, slow.scene, slow.mode.open[0], closing[0]);
      State<dynamic> brought = at.state;
      brought.now = slow.state.now;
      set_state_after(bounces, Tail{}, at.scene, brought);
      EXPECT_LT(largest_difference(brought, slow.state), 2e-14) << beta << " impact " << impacts;
      EXPECT_EQ(brought.stops[0].speed, bounces.speed(0));
      EXPECT_NEAR(brought.stops[1].gap, slow.mode.open[1].gap(slow.state.value, slow.state.slope),
                  2e-14);
    }
    EXPECT_GE(impacts, beta > 1.0 ? 2 : 6) << beta;
  }
}

// The state at the limit, from twelve impacts, against sixty more and what is left of them: 1e-13.
TEST(Bounces, TheLimitAgreesWithResolvingWhatIsLeft) {
  for (const double beta : {0.0, 0.1, 0.5}) {
    Pressed at(beta, 0.3, 0.6);
    at.state.mode = &at.mode;
    Bounces<dynamic> bounces;
    std::vector<double> closing;
    ChatterTable table;
    ASSERT_TRUE(follow(bounces, at.state, at.scene, {0}, at.flight(), 2.5 / at.mode.fastest, false,
                       at.counters));
    extend(table, predict_limit(bounces));
    for (int k = 0; k < 12; ++k) {
      ASSERT_TRUE(find_next(bounces, at.counters)) << k;
      bounce(bounces, at.scene, closing);
      extend(table, predict_limit(bounces));
    }
    const auto limit = extrapolate(table, at.mode.fastest, 1e-12);
    ASSERT_TRUE(limit);
    Tail tail;
    EXPECT_LT(find_tail(bounces, table, *limit, tail), 1e-11);
    EXPECT_TRUE(undisturbed(bounces, tail));
    State<dynamic> there = at.state, later = at.state;
    there.now.phase = later.now.phase = 0.3 + bounces.time + limit->left;
    set_state_after(bounces, tail, at.scene, there);
    const double end = bounces.time + limit->left;
    for (int k = 0; k < 40 && find_next(bounces, at.counters); ++k)
      bounce(bounces, at.scene, closing);
    EXPECT_LT(bounces.speed(0), 1e-9);
    EXPECT_NEAR(end, bounces.time, 1e-8);
    tail = {};
    tail.left = end - bounces.time;  // the impulse of the rest is below rounding
    set_lanes_after(bounces, tail, at.scene, later);
    EXPECT_LT(largest_difference(there, later), 1e-9);
  }
}

// What an impact predicts of the limit is wrong by O(x^4), and so falls by r^4 from one impact to
// the next: within 15 percent where it is between rounding and the terms of higher order.
TEST(Bounces, PredictTheLimitToThirdOrder) {
  for (const double restitution : {0.5, 0.7})
    for (const double beta : {0.0, 0.1, 0.5}) {
      Pressed at(beta, 0.3, restitution);
      at.state.mode = &at.mode;
      Bounces<dynamic> bounces;
      std::vector<double> closing;
      ASSERT_TRUE(follow(bounces, at.state, at.scene, {0}, at.flight(), 2.5 / at.mode.fastest,
                         false, at.counters));
      std::vector<double> limits{predict_limit(bounces).limit};
      for (int k = 0; k < 24; ++k) {
        ASSERT_TRUE(find_next(bounces, at.counters)) << k;
        bounce(bounces, at.scene, closing);
        limits.push_back(predict_limit(bounces).limit);
      }
      int compared = 0;
      for (std::size_t k = 0; k + 1 < limits.size(); ++k) {
        const double error = limits[k] - limits.back(), next = limits[k + 1] - limits.back();
        if (std::abs(error) > 1e-7 || std::abs(next) < 1e-11) continue;
        EXPECT_NEAR(next / error, std::pow(restitution, 4), 0.15 * std::pow(restitution, 4))
            << restitution << " " << beta << " impact " << k;
        ++compared;
      }
      EXPECT_GE(compared, 2) << restitution << " " << beta;
    }
}

// Another mass on its way to a stop: followed up to the last impact before it gets there, however
// it is watched.
TEST(Bounces, EndWhereAnotherMassArrives) {
  int limits = 0;
  for (const double position : {0.6001, 0.605, 0.61, 0.62, 0.625, 0.63, 0.635}) {
    Pressed at(0.1, 0.3, 0.7);
    at.scene.stops[1].position = position;
    at.mode = build_contact_mode<dynamic>(at.scene, Held(3, 0));
    MotionState motion = start_of(at.scene);
    motion.displacement << 0.7, 0.1, 0.6;
    motion.velocity << 0.05, -0.06, 0.2;
    motion.instant.phase = 0.3;
    set_lanes(at.state, at.scene, at.mode, motion);
    at.state.mode = &at.mode;
    at.state.stops = {{0.0, 0.06, 1, 0.06}, {position - 0.6, -0.2, 0, 0.0}};
    Bounces<dynamic> bounces;
    std::vector<double> closing;
    ASSERT_TRUE(follow(bounces, at.state, at.scene, {0}, at.flight(), 2.5 / at.mode.fastest, false,
                       at.counters));
    ChatterTable table;
    extend(table, predict_limit(bounces));
    for (int k = 0; find_next(bounces, at.counters) && goes_on(bounces); ++k) {
      ASSERT_LT(k, 100);
      bounce(bounces, at.scene, closing);
      extend(table, predict_limit(bounces));
    }
    // The limit lies beyond, and is not taken however well it is known.
    if (const auto limit = extrapolate(table, at.mode.fastest, 1e9)) {
      Tail tail;
      find_tail(bounces, table, *limit, tail);
      EXPECT_FALSE(undisturbed(bounces, tail)) << position;
      ++limits;
    }
    // The next event is that arrival, and it lies before the next impact.
    State<dynamic> brought = at.state;
    brought.now.phase = 0.3 + bounces.time;
    set_state_after(bounces, Tail{}, at.scene, brought);
    EXPECT_NEAR(brought.stops[1].gap, at.mode.open[1].gap(brought.value, brought.slope), 2e-14);
    Flight<dynamic> flight;
    expand(at.mode, brought.value, brought.slope, 1.0 / at.mode.fastest, flight.expansion,
           at.counters);
    find_first_event(brought, at.scene, Clock(at.scene.omega), flight, at.counters);
    EXPECT_EQ(flight.event.kind, Happening::impact) << position;
    EXPECT_EQ(flight.event.stops, std::vector<std::size_t>{1}) << position;
  }
  EXPECT_GE(limits, 2);
}

}  // namespace
