// Masses at rest at their stops: who sticks, who leaves, and when, beside stiff links, along long
// chains and where nothing moves.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "reference/scenes/paper_scenes.hpp"
#include "tests/support/events.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace {

using namespace vibro_impact;
using namespace vibro_impact::testing;

// Figure 2 with a stiff second link. A mass held beside this link is released when its force falls
// to zero. The derivative of the force has the damper of the link, whose force has the rounding of
// the displacements times the stiffness: it must not decide.
TEST(AtRest, AMassBesideAStiffDampedLinkIsReleased) {
  struct Link {
    double stiffness, release, tolerance;
  };
  for (const auto &[stiffness, release, tolerance] : {Link{1e6, 5.477753624, 1e-6},
                                                      {1e8, 5.477753624, 1e-6},
                                                      {1e9, 5.47775362408, 2e-7},
                                                      {1e10, 5.477753624, 1e-6}}) {
    Scene scene = paper::figure2();
    scene.omega = 0.25;
    scene.stiffness = {1.0, stiffness};
    const std::vector<Event> events = events_of(scene, 0.0, 60.0),
                             releases = select(events, EventKind::release, 2);
    ASSERT_FALSE(releases.empty()) << stiffness;
    EXPECT_NEAR(releases[0].time, release, tolerance) << stiffness;
  }
}

// Mass 1 stands at its stop without force. The rate of its force is B Omega - 0.1, from a sine and
// from the neighbour that leaves at the speed 0.1: its sign decides.
TEST(AtRest, TheRateOfTheForcingDecides) {
  for (const double sine : {1.0, 3.0}) {
    const Scene scene{.mass = {1.0, 1.0},
                      .stiffness = {1.0, 1.0},
                      .sine = {sine, 0.0},
                      .omega = 0.05,
                      .stops = {{1, Side::upper, 0.0}},
                      .velocity = {0.0, -0.1}};
    const std::vector<Event> sticks = select(events_of(scene, 0.0, 0.1), EventKind::stick);
    EXPECT_EQ(sticks.size(), sine * scene.omega > 0.1 ? 1u : 0u) << sine;
  }
}

Scene equal_chain(int masses, double beta) {
  const auto n = static_cast<std::size_t>(masses);
  Scene scene{.mass = std::vector<double>(n, 1.0),
              .stiffness = std::vector<double>(n, 1.0),
              .beta = beta,
              .amplitude = std::vector<double>(n, 0.0),
              .omega = 1.1,
              .restitution = 0.7,
              .stops = {{masses, Side::upper, 0.0}},
              .velocity = std::vector<double>(n, 0.0)};
  scene.amplitude[0] = 1.0;
  return scene;
}

// The first derivative of the last mass that is not zero has the order 25, beyond that of a step.
// The mass must still come back to its stop when the wave arrives, and be released from it.
TEST(AtRest, AMassThatAWaveReachesInAHighOrderKeepsItsStop) {
  Scene scene = equal_chain(13, 0.0);
  scene.velocity[0] = -1e-6;
  struct Highest : Recorder {
    double time = 0.0, highest = -1.0;
    double next_time() const override {
      return time;
    }
    void sample(const Moment &moment) override {
      highest = std::max(highest, moment.displacement(13));
      time += 0.05;
    }
  } samples;
  EventRecorder events;
  const Outcome outcome = require_complete(simulate(scene, 14.0, events, samples));
  EXPECT_LE(samples.highest, 0.0);
  const std::vector<Event> releases = select(events.events, EventKind::release);
  ASSERT_FALSE(releases.empty());
  EXPECT_NEAR(releases.back().time, 13.651637182926735, 1e-13);
  EXPECT_LT(outcome.counters.impacts, 200);
}

// The first derivative of the force on the last of 36 masses is 1e-308 of the fastest derivative of
// that order. It presses. Rounding may set the mass free while its force lies below rounding, but
// not in motion.
TEST(AtRest, AMassAtTheEndOfALongChainBesideAStiffLinkIsHeld) {
  for (const int masses : {20, 36, 60})
    for (const std::size_t stiff : {1u, 7u}) {
      Scene scene = equal_chain(masses, 0.1);
      scene.stiffness[stiff] = 1e9;
      const std::vector<Event> events = events_of(scene, 0.0, 0.01);
      ASSERT_FALSE(events.empty()) << masses;
      EXPECT_EQ(events[0].kind, EventKind::stick);
      EXPECT_EQ(events[0].time, 0.0);
      for (const Event &event : events) EXPECT_LE(std::abs(event.velocity_before), 1e-18);
    }
}

// Everything stands after a while. From then on a step is as long as the time before.
TEST(AtRest, AChainThatStandsTakesFewSteps) {
  const Scene scene{.mass = {1.0, 1.0},
                    .stiffness = {1.0, 1e9},
                    .beta = 0.1,
                    .constant = {1.0, 0.0},
                    .omega = 0.0,
                    .stops = {{1, Side::upper, 1.001}}};
  const Outcome outcome = require_complete(simulate(scene, 1e9));
  EXPECT_LT(outcome.counters.expansions, 5000);
  EXPECT_NEAR(outcome.state.displacement[0], 1.0, 1e-15);
  EXPECT_NEAR(outcome.state.displacement[1], 1.0, 1e-15);
}

// Mass 2 bounces on its stop at its rest position, r times as fast after each half period, when
// mass 1 is released beside it. The release is at a quarter period of the forcing, and mass 2 then
// moves as the free chain from rest.
TEST(AtRest, AReleaseBesideAMassWhoseBouncesHaveDiedDownGoesOn) {
  for (const double r : {0.1, 1e-4}) {
    const Scene scene{.mass = {1.0, 1.0},
                      .stiffness = {1.0, 1.0},
                      .amplitude = {1.0, 0.0},
                      .omega = 0.01,
                      .restitution = r,
                      .stops = {{1, Side::upper, 0.0}, {2, Side::upper, 0.0}},
                      .velocity = {0.0, -0.1}};
    EventRecorder events;
    const Outcome outcome = require_complete(simulate(scene, 200.0, events));
    const std::vector<Event> releases = select(events.events, EventKind::release, 1);
    ASSERT_EQ(releases.size(), 1u) << r;
    EXPECT_NEAR(releases[0].time, 157.07963267948965865, 3e-14 * 157.0);
    EXPECT_NEAR(outcome.state.displacement[1], -0.39796319816975922, 1e-13) << r;
  }
  const Scene other{.mass = {1.0, 1.0},
                    .stiffness = {0.004, 1.0},
                    .amplitude = {0.1, 0.0},
                    .omega = 0.012422360248447204,
                    .restitution = 1e-4,
                    .stops = {{1, Side::upper, 0.0}, {2, Side::upper, 0.0}},
                    .velocity = {0.0, -0.1}};
  const std::vector<Event> releases = select(events_of(other, 0.0, 130.0), EventKind::release, 1);
  ASSERT_FALSE(releases.empty());
  EXPECT_NEAR(releases.back().time, 126.449104306989186, 3e-14 * 126.0);
}

// The neighbours of mass 2 or 3 are released when this mass, which no force acts on, has just hit
// its stop at 1e-229. Its acceleration is then a sum of those of the modes, zero but for rounding,
// which must not bring it back. A forcing moves the first chain. In the second one two heavy masses
// at the ends press the neighbours, for a quarter of their period.
TEST(AtRest, AMassWhoseBouncesHaveDiedDownLeavesWithTheOthers) {
  const Scene forced{.mass = {1.0, 1.0, 1.0},
                     .stiffness = {0.004, 2.7, 2.7},
                     .amplitude = {0.9, 0.3, 0.0},
                     .omega = std::sqrt(2.7) / 40.0,
                     .restitution = 1e-12,
                     .stops = {{1, Side::upper, 0.0}, {2, Side::upper, 0.0}, {3, Side::upper, 0.0}},
                     .velocity = {0.0, 0.0, -0.17}};
  const Scene free{.mass = {800.0, 1.0, 1.0, 1.0, 800.0},
                   .stiffness = {0.7, 2.0, 2.7, 2.7, 2.0},
                   .ground = {0.0, 0.0, 0.0, 0.0, 0.7},
                   .omega = 0.0,
                   .restitution = 1e-12,
                   .stops = {{2, Side::upper, 0.0}, {3, Side::upper, 0.0}, {4, Side::upper, 0.0}},
                   .displacement = {1.0, 0.0, 0.0, 0.0, 0.6},
                   .velocity = {0.0, 0.0, -0.17, 0.0, 0.0}};
  for (const auto &[scene, until] : {std::pair{forced, 39.0}, {free, 28.0}}) {
    const Outcome outcome = require_complete(simulate(scene, until));
    EXPECT_EQ(outcome.counters.releases, 2);
    EXPECT_EQ(outcome.counters.sticks, 2);
    EXPECT_LT(outcome.counters.impacts, 30);
  }
}

// All 100 masses are at rest on their stops but the first, which moves away. The decision about the
// others takes 200 orders, ten steps.
TEST(AtRest, DecisionsCountAsSteps) {
  Scene scene;
  scene.mass.assign(100, 1.0);
  scene.stiffness.assign(100, 1.0);
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

}  // namespace
