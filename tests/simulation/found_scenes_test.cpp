// Scenes that random search found to go wrong once, cut down to what it took. Each names what went
// wrong.
#include <gtest/gtest.h>

#include "reference/scenes/degenerate_cases.hpp"
#include "tests/events.hpp"
#include "witness.hpp"

namespace {

using namespace vibro_impact;
using namespace vibro_impact::testing;

// Runs with all chatter resolved before a witness, which finds every flight where it takes it
// itself, within this share of the motion. How many events.
std::size_t expect_the_motion_of_a_witness(const Scene &scene, double until, double tolerance) {
  Witness witness(scene);
  EventRecorder events;
  witness.close(require_complete(simulate(scene, until, all_impacts, witness, events)).state);
  EXPECT_LT(witness.apart(), tolerance * witness.size()) << until;
  EXPECT_LT(static_cast<double>(witness.deepest), tolerance) << until;
  return events.events.size();
}

// Mass 2 is pulled off its stop at t = 0, at the very instant at which mass 1 runs into its own:
// the damper between them changes the acceleration mass 2 leaves with, which had been fixed before.
// Its gap then moved apart from the motion by a part in 1e3. 1e-14: rounding.
TEST(FoundScenes, ANeighboursImpactAtTheInstantOfLeaving) {
  Scene scene = extremes::chain(2, 1.0);
  scene.amplitude = {0.0, -1.0};
  scene.omega = 0.0;
  scene.restitution = 0.0;
  scene.velocity = {0.1, 0.0};
  scene.stops = {{1, Side::upper, 0.0}, {2, Side::upper, 0.0}};
  for (const double until : {6e-5, 0.01, 1.0}) expect_the_motion_of_a_witness(scene, until, 1e-14);
}

// At rest on stops that stand where the masses do, no force on mass 1: it is held with a force that
// is zero with its first derivative until motion comes along the chain. The run took that for a
// force that grazes zero, over and over at t = 0, and did not return.
TEST(FoundScenes, AHoldForceThatLeavesZeroWithAHigherDerivative) {
  for (const double k : {0.3, 1.0, 2.0})
    for (const double omega : {0.0, 1.0}) {
      Scene scene = extremes::chain(2, 0.0);
      scene.stiffness = {k, k};
      scene.amplitude = {0.0, -1.0};
      scene.omega = omega;
      scene.restitution = 0.5;
      scene.stops = {{1, Side::upper, 0.0}, {2, Side::upper, 0.0}};
      expect_the_motion_of_a_witness(scene, 1.0, 1e-14);
      // Both masses leave towards -x: x1'''' = -k / m^2 at t = 0, m = 1.
      const Outcome outcome = simulate(scene, 1e-3);
      EXPECT_NEAR(outcome.state.displacement[0], -k * 1e-12 / 24.0, 1e-5 * k * 1e-12 / 24.0);
      EXPECT_EQ(outcome.state.held, (Held{0, 0}));
    }
}

// After an impact with r = 1e-300 the mass leaves its stop slowly and is pulled away; the search
// for its next impact lost the whole step to cancellation, and the mass went through the stop.
TEST(FoundScenes, ASlowDepartureBeforeAnImpact) {
  for (const double r : {1e-300, 1e-100, 1e-30, 1e-18}) {
    Scene scene = extremes::chain(2, 0.0);
    scene.stiffness = {8000.0, 10.0};
    scene.amplitude = {-1.0, 1.0};
    scene.omega = 0.0;
    scene.restitution = r;
    scene.stops = {{1, Side::upper, 0.0}};
    EXPECT_GT(expect_the_motion_of_a_witness(scene, 20.0, 1e-12), 10u) << r;
  }
}

// A gap below a thousandth of the motion was carried from span to span and never compared with it
// again; it drifted by the rounding of the acceleration, integrated twice, to 5e-9 here. The steady
// response, 1 / 0.0015, is 4e4 times the motion, and the frequencies of the soft modes are known to
// epsilon times a ratio of stiffness of 1e6: 1e-10 is what remains of the digits.
TEST(FoundScenes, ASmallGapOverManySpans) {
  Scene scene;
  scene.mass = {0.77, 0.725, 7.0, 1.0};
  scene.stiffness = {0.0015, 5.34, 2000.0, 1.0};
  scene.amplitude = {1.0, 0.0, 0.0, 0.0};
  scene.omega = 0.011;
  scene.restitution = 0.0;
  scene.displacement = {0.0, 0.0, 0.016405824460808776, 0.0};
  scene.stops = {{2, Side::upper, 0.0}};
  expect_the_motion_of_a_witness(scene, 1.0, 1e-10);
}

// Mass 1 hits at 0.2 as the chatter of mass 2 begins, which is over at once. Both were taken for
// one chatter, at rest when that of mass 1 would have been.
TEST(FoundScenes, AChatterOverAtTheInstantOfAFastImpact) {
  Scene scene = extremes::chain(2, 0.1);
  scene.amplitude = {1.0, 1.0};
  scene.omega = 0.0;
  scene.restitution = 0.7;
  scene.displacement = {0.1, 0.2};
  scene.velocity = {0.2, 1e-30};
  scene.stops = {{1, Side::upper, 0.1}, {2, Side::upper, 0.2}};
  EXPECT_GT(expect_the_motion_of_a_witness(scene, 5.0, 1e-13), 50u);
}

// Mass 1 starts into its stop beside mass 2, at rest on its own: the damper presses that by the
// speed before the impact, and pulls it by the one after. It was held for no time at all.
TEST(FoundScenes, AnImpactAtTheStartBesideAMassAtRest) {
  Scene scene = extremes::chain(2, 0.5);
  scene.restitution = 0.5;
  scene.velocity = {0.2, 0.0};
  scene.stops = {{1, Side::upper, 0.0}, {2, Side::upper, 0.0}};
  const std::vector<Event> events = events_of(scene, 0.0, 0.1);
  ASSERT_EQ(events.size(), 1u);
  EXPECT_EQ(events[0].kind, EventKind::impact);
  EXPECT_EQ(events[0].mass, 1);
  EXPECT_LT(simulate(scene, 0.1).state.displacement[1], 0.0);
}

// Only the first of ten masses is forced, and has no stop: x_1'' = 1/2 at first, and mass j follows
// its neighbour, x_j = t^2j / (2 (2j)!) to leading order. That is far below rounding for a while,
// but no mass is held: all move as in the chain without stops until one of them comes back.
TEST(FoundScenes, TenMassesThatFollowTheFirst) {
  const Scene scene = extremes::following_the_first(0.7, 0.7);
  Scene free = scene;
  free.stops.clear();
  const double first = events_of(scene, 0.0, 30.0).at(0).time;
  EXPECT_GT(first, 0.5);
  for (double time = first / 64.0; time < first; time += first / 64.0) {
    const MotionState state = simulate(scene, time).state, truth = simulate(free, time).state;
    for (std::size_t i = 0; i < 10; ++i) {
      EXPECT_NEAR(state.displacement[i], truth.displacement[i], 1e-14) << i << " at " << time;
      EXPECT_NEAR(state.velocity[i], truth.velocity[i], 1e-14) << i << " at " << time;
    }
  }
  // The next term is (2j + 2)(2j + 1) / t^2 times smaller, or that of the forcing, and less.
  const MotionState early = simulate(scene, 0.01).state;
  double leading = scene.amplitude[0];
  for (int j = 1; j <= 4; ++j) {
    leading *= 0.01 * 0.01 / (2.0 * j * (2.0 * j - 1.0));
    EXPECT_NEAR(early.displacement[static_cast<std::size_t>(j - 1)], leading, 1e-4 * leading) << j;
  }
}

}  // namespace
