// Chains of two and three coupled masses with a sine, a constant force, springs to the ground and a
// stop with its own restitution, against the 50-digit generator, which shares neither code nor
// method with the library.
#include <gtest/gtest.h>

#include <algorithm>

#include "reference/generator/event_driven.hpp"
#include "reference/scenes/paper_scenes.hpp"
#include "reference/truth/event_comparison.hpp"
#include "tests/support/events.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace {

using namespace vibro_impact;

Scene three_masses() {
  return {.mass = {1.0, 2.0, 0.5},
          .stiffness = {1.0, 0.7, 1.5},
          .beta = 0.1,
          .amplitude = {0.5, 0.0, 0.2},
          .sine = {0.1, -0.3, 0.0},
          .constant = {-0.05, 0.1, 0.02},
          .ground = {0.0, 0.4, 0.2},
          .omega = 0.6,
          .restitution = 0.5,
          .stops = {{1, Side::lower, -0.3}, {2, Side::upper, 0.3, 0.3}, {3, Side::upper, 0.35}}};
}

Scene two_masses() {
  Scene scene = paper::figure2();
  scene.sine = {0.0, 0.2};
  scene.constant = {-0.1, 0.05};
  scene.ground = {0.3, 0.0};
  return scene;
}

// A strongly damped chain, the modes of which are carried as two decays each.
Scene creeping() {
  Scene scene = two_masses();
  scene.beta = 8.0;
  scene.stops[0].position = -0.05;
  scene.stops[1].position = 0.03;
  return scene;
}

// 1e-12: some hundred roundings of a time of 40, passed on by the events before.
TEST(Forces, OfCoupledMassesAgreeWith50Digits) {
  constexpr double until = 40.0;
  for (const Scene &scene : {two_masses(), three_masses(), creeping()}) {
    std::vector<Event> truth;
    for (const auto &event :
         vibro_impact_reference::simulate(vibro_impact_reference::in_digits(scene, until)).events)
      truth.push_back(truth::event_at(static_cast<double>(event.time),
                                      static_cast<int>(event.mass) + 1, event.kind,
                                      static_cast<double>(event.velocity_before)));
    const auto differences = truth::compare(
        vibro_impact::testing::events_of(scene, 0.0, until, {.limit_below_speed = 1e-4}), truth,
        scene, {.reach = 1e-3});
    EXPECT_EQ(differences.first, "");
    EXPECT_LT(differences.time, 1e-12);
    EXPECT_LT(differences.velocity, 1e-12);
    EXPECT_GE(differences.matched, 8u);
    EXPECT_GE(std::ranges::count(truth, EventKind::stick, &Event::kind), 1);
  }
}

// The scene of three masses has every field, but for a start: a new one must be given here.
TEST(Forces, AreAllInTheSceneOfThreeMasses) {
  const Scene scene = three_masses(), none;
  for (const auto &field : list_fields)
    if (field.value != &Scene::displacement && field.value != &Scene::velocity) {
      EXPECT_FALSE((scene.*field.value).empty()) << field.name;
    }
  for (const auto &field : scalar_fields)
    EXPECT_NE(scene.*field.value, none.*field.value) << field.name;
}

// Forces that a scene leaves out cost nothing: the work is the same to the last operation, and so
// is the motion.
TEST(Forces, OfZeroChangeNothing) {
  Scene zero = paper::figure2();
  zero.sine = zero.constant = zero.ground = {0.0, 0.0};
  const Outcome without = simulate(paper::figure2(), 200.0), with = simulate(zero, 200.0);
  EXPECT_EQ(without.counters.products, with.counters.products);
  EXPECT_EQ(without.counters.expansions, with.counters.expansions);
  EXPECT_NEAR(without.state.displacement[0], with.state.displacement[0], 1e-13);
}

}  // namespace
