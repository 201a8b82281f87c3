// No length, time or mass is special: what is equal, small or at rest is measured by the motion
// itself, and not by the frequencies of a chain that hardly feels its springs.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/support/events.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace {

using namespace vibro_impact;
using namespace vibro_impact::testing;

// Masses that fall from 1 onto stops at 0 with these accelerations. Their link is so soft that it
// changes no digit.
Scene two_balls(double mass, double first, double second, double restitution) {
  return {.mass = {mass, mass},
          .stiffness = {0.0, 1e-12},
          .constant = {-mass * first, -mass * second},
          .omega = 0.0,
          .restitution = restitution,
          .stops = {{1, Side::lower, 0.0}, {2, Side::lower, 0.0}},
          .displacement = {1.0, 1.0}};
}

// 4e-16 of the time: two roundings.
TEST(Impacts, OfFallingMassesAreSimultaneousOnlyWithinRounding) {
  struct Fall {
    double mass, acceleration, difference;
  };
  for (const auto &[mass, acceleration, difference] :
       {Fall{1.0, 1e8, 2e3}, {1.0, 1.0, 1e-8}, {1e8, 1.0, 1e-5}, {1.0, 1.0, 1e-12}}) {
    const double second = acceleration + difference;
    const Scene scene = two_balls(mass, acceleration, second, 0.5);
    const double slow = std::sqrt(2.0 / acceleration), fast = std::sqrt(2.0 / second);
    const std::vector<Event> events = events_of(scene, 0.0, 1.5 * slow);
    ASSERT_GE(events.size(), 2u);
    EXPECT_EQ(events[0].mass, 2);
    EXPECT_EQ(events[1].mass, 1);
    EXPECT_NEAR(events[0].time, fast, 4e-16 * fast) << acceleration << " " << difference;
    EXPECT_NEAR(events[1].time, slow, 4e-16 * slow) << acceleration << " " << difference;
  }
}

struct FallingMass {
  double mass, stiffness, force, omega, restitution, height;
};

// A ball of constant weight rests after (1 + 2 r / (1 - r)) times its first fall, whatever the
// rates of its spring and of a forcing that hardly turns. 1e-12: the tolerance of a limit and what
// the forcing and the spring change.
TEST(Chatter, OfAFallingMassEndsWhereItsImpactsDo) {
  for (const auto &[mass, stiffness, force, omega, r, height] :
       {FallingMass{1e8, 1e-12, 1e8, 0.0, 3e-5, 1.0},
        {1.0, 0.0, 1.0, 1e-8, 1e-7, 1.0},
        {1.0, 0.0, 1e8, 0.0, 1e-7, 1e-8},
        {1.0, 0.0, 1.0, 1e-14, 0.5, 1.0},
        {1.0, 0.0, 1.0, 1e-14, 0.9, 1.0},
        {1.0, 1e-24, 1.0, 0.0, 0.7, 1.0}}) {
    const Scene scene{.mass = {mass},
                      .stiffness = {stiffness},
                      .amplitude = {-force},
                      .omega = omega,
                      .restitution = r,
                      .stops = {{1, Side::lower, 0.0}},
                      .displacement = {height}};
    const double fall = std::sqrt(2.0 * height * mass / force),
                 rest = fall * (1.0 + 2.0 * r / (1.0 - r));
    for (const RunOptions &options : {RunOptions{}, all_impacts}) {
      const std::vector<Event> events = events_of(scene, 0.0, 1.5 * rest, options);
      ASSERT_FALSE(events.empty());
      EXPECT_EQ(events.back().kind, EventKind::stick) << omega << " " << r;
      EXPECT_NEAR(events.back().time, rest, 1e-12 * rest) << omega << " " << r;
    }
  }
}

// The start of a chain in units of time from 1 to 1e10 comes back from its modes. 1e-14: some fifty
// roundings.
TEST(Modes, OfAChainInSmallUnitsAreAsAccurateAsInOthers) {
  for (const double unit : {1.0, 1e-6, 1e-12, 1e-16, 1e-20})
    for (const bool tied : {false, true}) {
      Scene scene{.mass = {3.0, 2.0, 1.0},
                  .stiffness = {5.0 * unit, 0.5 * unit, 1.0 * unit},
                  .omega = 0.0,
                  .stops = {{3, Side::upper, 9.0}},
                  .displacement = {1.0, 0.0, 0.0}};
      if (tied) scene.ground = {0.3 * unit, 0.7 * unit, 1.1 * unit};
      const MotionState start = simulate(scene, 0.0).state;
      EXPECT_NEAR(start.displacement[0], 1.0, 1e-14) << unit;
      EXPECT_NEAR(start.displacement[1], 0.0, 1e-14) << unit;
      EXPECT_NEAR(start.displacement[2], 0.0, 1e-14) << unit;
    }
}

// The product of two masses of 1e160 is infinite. 1e-14: some fifty roundings.
TEST(Modes, OfHeavyMassesAreThoseOfLightOnes) {
  const auto end_of = [](double unit) {
    const Scene scene{.mass = {unit, unit},
                      .stiffness = {unit, unit},
                      .stops = {{2, Side::upper, 9.0}},
                      .displacement = {1.0, 0.0}};
    return simulate(scene, 3.0).state.displacement;
  };
  const std::vector<double> heavy = end_of(1e160), light = end_of(1.0);
  EXPECT_NEAR(heavy[0], light[0], 1e-14);
  EXPECT_NEAR(heavy[1], light[1], 1e-14);
}

// A spring so soft that a step of two radians has an infinite square.
TEST(Modes, OfASpringNearTheLeastNumberStayInRange) {
  const Scene scene{.mass = {1.0},
                    .stiffness = {1e-310},
                    .omega = 0.0,
                    .restitution = 0.5,
                    .stops = {{1, Side::upper, 1.0}},
                    .velocity = {0.5}};
  const Outcome outcome = require_complete(simulate(scene, 4.0));
  EXPECT_EQ(outcome.counters.impacts, 1);
  EXPECT_NEAR(outcome.state.displacement[0], 0.5, 1e-15);
}

}  // namespace
