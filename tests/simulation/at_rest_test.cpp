// Masses at rest at their stops: who sticks, who leaves, and when. Forces are zero or rounding, or
// a damper adds to them. random_scenes_test tries long chains at rest and stiff links.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "reference/scenes/extreme_scenes.hpp"
#include "tests/support/events.hpp"
#include "tests/support/mode_motion.hpp"
#include "tests/support/wide_scenes.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace {

using namespace vibro_impact;
using namespace vibro_impact::testing;

// All 100 masses are at rest on their stops but the first, which moves away. The decision about the
// others takes 200 orders, ten steps.
TEST(AtRest, DecisionsCountAsSteps) {
  Scene scene = extremes::chain(100, 0.0);
  scene.velocity.assign(100, 0.0);
  scene.velocity[0] = -1.0;
  for (int mass = 2; mass <= 100; ++mass) scene.stops.push_back({mass, Side::upper, 0.0});
  RunOptions options;
  options.max_steps = 8;
  const Outcome outcome = simulate(scene, 10.0, options);
  EXPECT_EQ(outcome.ending, Ending::given_up);
  EXPECT_EQ(outcome.counters.expansions, 1);
  EXPECT_GE(outcome.counters.rest_orders, 160);
}

// All masses have a stop where they start, at 0.1. The hold force of a mass without forcing is the
// sum of k (x_j - 0.1) + beta k v_j over its neighbours and the wall. It presses only where a
// neighbour approaches its stop and there is a damper, though it may be zero but for the rounding
// of the tensions and their rates. At other times such a mass does not stick.
TEST(AtRest, NothingHoldsAMassThatNoForcePresses) {
  int sticks = 0;
  for (const double beta : {0.0, 0.5})
    for (unsigned seed = 1; seed <= 200; ++seed) {
      Draw draw{std::mt19937(seed)};
      Scene scene = extremes::chain(draw.between(3, 8), beta);
      scene.stiffness.assign(scene.mass.size(), draw.one_of({0.25, 1.0, 3.0}));
      scene.omega = draw.one_of({0.3, 0.7, 1.0});
      scene.restitution = draw.one_of({0.0, 0.3, 0.7});
      for (int i = 1; i <= scene.masses(); ++i) {
        scene.amplitude.push_back(draw.one_in(2) ? 0.5 : 0.0);
        scene.displacement.push_back(0.1);
        scene.stops.push_back({i, Side::upper, 0.1});
      }
      const auto approaches = [&scene](const Moment &moment, int mass) {
        return mass >= 1 && mass <= scene.masses() && moment.velocity(mass) > 0.0;
      };
      AtEvents found([&](const Event &event, const Moment &moment) {
        if (event.kind != EventKind::stick) return false;
        ++sticks;
        const bool pushed =
            approaches(moment, event.mass - 1) || approaches(moment, event.mass + 1);
        EXPECT_TRUE(scene.forced(event.mass) || (beta > 0.0 && pushed))
            << "beta " << beta << ", seed " << seed;
        return false;
      });
      require_complete(simulate(scene, 30.0 / scene.omega, found));
    }
  EXPECT_GT(sticks, 1000);
}

// A force P and the neighbour that approaches its stop at -0.25 press a mass into its stop. The
// neighbour hits, with r = 0, where this force k (x + beta v) + P has just fallen to zero. By the
// impact it jumps to -k beta v > 0, so that the mass stays. P is off by a rounding, so that either
// comes first, and both are one instant.
TEST(AtRest, AnImpactAtTheRootOfAForceKeepsAMassHeld) {
  for (const std::size_t hit : {0u, 1u}) {
    const std::size_t pressed = 1 - hit;
    Scene scene{.mass = {1.0, 1.0},
                .stiffness = {1.0, 2.0},
                .beta = 0.3,
                .constant = {0.0, 0.0},
                .ground = {0.0, 1.0},
                .omega = 0.0,
                .restitution = 0.0,
                .stops = {{static_cast<int>(hit) + 1, Side::lower, -0.25},
                          {static_cast<int>(pressed) + 1, Side::upper, 0.0}},
                .velocity = {0.0, 0.0}};
    scene.constant[hit] = -3.0;
    scene.constant[pressed] = 9.0;
    const std::vector<Event> impacts = select(events_of(scene, 0.0, 1.0), EventKind::impact);
    ASSERT_FALSE(impacts.empty());
    const double root = 2.0 * (0.25 - scene.beta * impacts.front().velocity_before);
    for (const int roundings : {-1, 0, 1}) {
      scene.constant[pressed] = root * (1.0 + roundings * 0x1p-52);
      const std::vector<Event> events = events_of(scene, 0.0, 0.5);
      EXPECT_EQ(select(events, EventKind::impact).size(), 1u) << hit << " " << roundings;
      EXPECT_TRUE(select(events, EventKind::release).empty()) << hit << " " << roundings;
    }
  }
}

// The masses beside mass 2 swing against each other at one frequency, and their springs pull it
// with k x and -k x, to all orders. In twice the precision these cancel but for rounding.
TEST(AtRest, ForcesThatCancelToRoundingHoldNoMass) {
  for (const double m : {5.0, 7.0, 11.0, 13.0, 17.0, 19.0, 23.0, 29.0}) {
    const Scene scene{.mass = {m, 1.0, 3.0 * m},
                      .stiffness = {0.0, 1.0, 3.0},
                      .omega = 0.0,
                      .stops = {{2, Side::upper, 0.0}},
                      .displacement = {0.75, 0.0, -0.25}};
    EXPECT_TRUE(events_of(scene, 0.0, 0.0).empty()) << m;
  }
}

// The rate of the force on mass 2, at its stop without force, is the sum of those of a sine and of
// both neighbours. It is zero but for the rounding of v3, which decides whether mass 2 sticks. With
// a damper the accelerations enter the rate, too. 1e-18: some ten roundings of extended precision.
TEST(AtRest, TheRoundingOfARateDecides) {
  std::mt19937_64 generator(7);
  const auto between = [&](double a, double b) {
    return std::uniform_real_distribution<>(a, b)(generator);
  };
  for (int draw = 0; draw < 300; ++draw) {
    const double omega = between(0.2, 1.0), sine = between(-1.0, 1.0), k2 = between(0.5, 2.0),
                 k3 = between(0.5, 2.0), v1 = between(-1.0, 1.0);
    for (const double beta : {0.0, 0.125})
      for (const double force : {-1.0, 1.0}) {
        const double m = 3.0, a = beta * force / m, v3 = -(omega * sine + k2 * (v1 + a)) / k3 - a;
        const Scene scene{.mass = {m, 1.0, m},
                          .stiffness = {1.0, k2, k3},
                          .beta = beta,
                          .sine = {0.0, sine, 0.0},
                          .constant = {force, 0.0, force},
                          .omega = omega,
                          .restitution = 0.5,
                          .stops = {{2, Side::upper, 0.0}},
                          .displacement = {-beta * v1, 0.0, -beta * v3},
                          .velocity = {v1, 0.0, v3}};
        const Outcome outcome = simulate(scene, 0.5, {.max_steps = 2000});
        EXPECT_EQ(outcome.ending, Ending::reached) << draw << " " << beta << " " << force;
        const Real change = static_cast<Real>(beta) * force / m,
                   rate = static_cast<Real>(omega) * sine + k2 * (v1 + change) + k3 * (v3 + change);
        if (std::abs(rate) < 1e-18L) continue;
        EXPECT_EQ(simulate(scene, 0.0).state.held[1], rate > 0 ? 1 : 0) << draw << " " << beta;
      }
  }
}

// Until the wave arrives, the hold force on the last mass of a long chain is rounding. A force that
// is nothing else over a whole step releases no mass, which would only come to stick again: 471
// times in these chains instead of 214. The bound leaves room for the rounding of other compilers.
TEST(AtRest, AForceOfRoundingReleasesNoMassOfALongChain) {
  long long sticks = 0;
  for (unsigned seed = 1; seed <= 150; ++seed) {
    const Trial trial = long_chain_at_rest(seed);
    sticks += simulate(trial.scene, trial.until, {.max_steps = 3000}).counters.sticks;
  }
  EXPECT_LE(sticks, 320);
}

// A mass sticks under a force of 6e-17 that falls with the slope -sin(1): it vanishes at the same
// instant of the clock. The release is decided two roundings of the clock later, after one step.
// Three more lead to the end.
TEST(AtRest, AReleaseAtTheInstantOfAStickComesTwoRoundingsLater) {
  const Scene scene{.mass = {1.0},
                    .stiffness = {1.0},
                    .amplitude = {1.0},
                    .constant = {-std::nextafter(std::cos(1.0), 0.0)},
                    .omega = 1.0,
                    .restitution = 0.5,
                    .stops = {{1, Side::upper, 0.0}}};
  EventRecorder events;
  const Outcome outcome =
      Simulation(scene, MotionState{{0, 1.0}, {0.0}, {0.0}, {0}}).advance(2.0, events);
  ASSERT_EQ(events.events.size(), 2u);
  EXPECT_EQ(events.events[0].kind, EventKind::stick);
  EXPECT_EQ(events.events[1].kind, EventKind::release);
  EXPECT_EQ(events.events[1].time, 1.0 + 0x1p-51);
  EXPECT_EQ(outcome.counters.expansions, 4);
}

// A mass rests at its stop, and its neighbour leaves so slowly that the force between them lies
// below rounding. The pair drifts away with half the speed of the neighbour, and a force that
// brings it back with the acceleration a makes it hit the stop after the time v / a.
TEST(AtRest, AMassWithoutForceThatDriftsAwayComesBackToItsStop) {
  constexpr double speed = 1e-29, back = 1e7, force = speed / back;
  const Scene scene{.mass = {1.0, 1.0},
                    .stiffness = {0.0, 1.0},
                    .beta = 0.1,
                    .constant = {force, force},
                    .omega = 0.0,
                    .restitution = 0.5,
                    .stops = {{1, Side::upper, 1.0}},
                    .displacement = {1.0, 1.0},
                    .velocity = {0.0, -speed}};
  const std::vector<Event> events = events_of(scene, 0.0, 1.1 * back, {.max_steps = 10'000});
  ASSERT_GE(events.size(), 1u);
  EXPECT_NEAR(events[0].time, back, 1e-6 * back);
  EXPECT_NEAR(events[0].velocity_before, 0.5 * speed, 1e-6 * speed);
}

// Forces far below the rounding of k x at x = 1 press masses onto their stops. A mass that stays
// where it was placed stands there exactly: the springs between such masses have no rounding.
TEST(AtRest, ASmallForceHoldsMassesAtStopsThatAreNotAtZero) {
  for (const double place : {0.0, 1.0})
    for (const double force : {1e-24, 1e-27, 1.9e-32})
      for (const double restitution : {0.0, 0.5}) {
        const Scene scene{.mass = {1.0, 1.0},
                          .stiffness = {0.0, 1e3},
                          .beta = 0.1,
                          .constant = {force, force},
                          .omega = 0.0,
                          .restitution = restitution,
                          .stops = {{1, Side::upper, place}, {2, Side::upper, place}},
                          .displacement = {place, place}};
        const std::vector<Event> events = events_of(scene, 0.0, 1e6, {.max_steps = 10'000});
        EXPECT_EQ(select(events, EventKind::stick).size(), 2u) << place << ' ' << force;
        EXPECT_EQ(events.size(), 2u) << place << ' ' << force;
      }
}

// A force of 3e-18 that falls holds mass 1. Beside a link of 1e9 it was taken for zero, and its
// slope released the mass: it came back after 3e-13, five million times.
TEST(AtRest, ASmallForceThatFallsHoldsAMassBesideAStiffLink) {
  for (const double place : {0.0, 1.0}) {
    const Scene scene{.mass = {1.0, 0.5},
                      .stiffness = {0.0, 1e9},
                      .beta = 1e-3,
                      .amplitude = {3e-18, 0.0},
                      .sine = {-1.5e-18, 0.0},
                      .omega = 1.0,
                      .restitution = 0.5,
                      .stops = {{1, Side::upper, place}, {2, Side::upper, place}},
                      .displacement = {place, place}};
    const std::vector<Event> events = events_of(scene, 0.0, 1.0, {.max_steps = 10'000});
    ASSERT_EQ(events.size(), 1u);
    EXPECT_EQ(events[0].kind, EventKind::stick);
    EXPECT_EQ(events[0].mass, 1);
  }
}

}  // namespace
