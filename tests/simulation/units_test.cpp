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

struct Ball {
  double mass, stiffness, force, omega, restitution, height;
};

// A ball of constant weight rests after (1 + 2 r / (1 - r)) times its first fall, whatever the
// rates of its spring and of a forcing that hardly turns. 1e-12: the tolerance of a limit and what
// the forcing and the spring change.
TEST(Chatter, OfAFallingMassEndsWhereItsImpactsDo) {
  for (const auto &[mass, stiffness, force, omega, r, height] :
       {Ball{1e8, 1e-12, 1e8, 0.0, 3e-5, 1.0},
        {1.0, 0.0, 1.0, 1e-8, 1e-7, 1.0},
        {1.0, 0.0, 1e8, 0.0, 1e-7, 1e-8},
        {1.0, 0.0, 1.0, 1e-14, 0.5, 1.0},
        {1.0, 0.0, 1.0, 1e-14, 0.9, 1.0},
        {1.0, 1e-24, 1.0, 0.0, 0.7, 1.0},
        {1.0, 0.0, 1.0, 0.0, 0.99999, 1.0}}) {
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
      if (r > 0.99 && options.limit_below_speed == 0.0) continue;  // some millions of impacts
      const std::vector<Event> events = events_of(scene, 0.0, 1.5 * rest, options);
      ASSERT_FALSE(events.empty());
      EXPECT_LT(events.size(), 1'000'000u);
      EXPECT_EQ(events.back().kind, EventKind::stick) << omega << " " << r;
      EXPECT_NEAR(events.back().time, rest, 1e-12 * rest) << omega << " " << r;
    }
  }
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
