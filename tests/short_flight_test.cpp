// What keeps short flights short: bounds of how far the lanes reach, the forcing carried on, the
// return of a mass to the stop it has just left.
#include <gtest/gtest.h>

#include "paper_scenes.hpp"
#include "random_scenes.hpp"
#include "vibro_impact/first_return.hpp"
#include "vibro_impact/reach.hpp"

namespace {

using namespace vibro_impact;
constexpr int dynamic = Eigen::Dynamic;

// A gap or a hold force out of reach stays away, whatever the motion.
TEST(Reach, IsNeverExceeded) {
  double nearest = 0.0;
  int resonant = 0;
  for (unsigned seed = 1; seed <= 200; ++seed) {
    Scene scene = vibro_impact::testing::random_scene(seed);
    if (scene.stops.empty()) continue;
    if (seed % 3 == 0) {  // in resonance
      scene.beta = 0.0;
      const auto free = build_contact_mode<dynamic>(scene, Held(scene.mass.size(), 0));
      scene.omega = std::sqrt(free.lambda(0)) * (1.0 + 1e-9);
    }
    Held held(scene.mass.size(), 0);
    if (seed % 2 == 0)
      held[static_cast<std::size_t>(scene.stops[0].mass - 1)] =
          static_cast<signed char>(scene.stops[0].side);
    const auto mode = build_contact_mode<dynamic>(scene, held);
    if (mode.lanes() == 0) continue;
    resonant += mode.any_resonant;
    MotionState motion = start_of(scene);
    for (Eigen::Index i = 0; i < motion.displacement.size(); ++i)
      if (held[static_cast<std::size_t>(i)] == 0) {
        motion.displacement(i) = std::sin(seed + 3.0 * static_cast<double>(i));
        motion.velocity(i) = std::cos(2.0 * seed + static_cast<double>(i));
      }
    State<dynamic> state;
    set_lanes(state, scene, mode, motion);
    if (seed % 9 == 0)
      state.value.head(mode.modal_lanes()) = state.slope.head(mode.modal_lanes()) = 0.0;
    for (const double reach : {0.01, 0.3, 2.0, 30.0}) {
      const double time = reach / mode.fastest;
      const auto speeds = speed_bounds(mode, state.value, state.slope, time);
      State<dynamic> there = state;
      flow(mode, scene, state.value, state.slope, time, there.value, there.slope);
      const auto moved = [&](const Reading<dynamic> &reading) {
        return std::abs(reading(there.value, there.slope) - reading(state.value, state.slope));
      };
      for (const auto &open : mode.open) {
        EXPECT_LE(moved(open.gap), reach_of_gap(open.gap, speeds, time)) << seed;
        EXPECT_LE(moved(open.press), reach_of(mode, open.press, speeds, time)) << seed;
        nearest = std::max(nearest, moved(open.gap) / reach_of_gap(open.gap, speeds, time));
      }
      for (const auto &closed : mode.closed)
        EXPECT_LE(moved(closed.press), reach_of(mode, closed.press, speeds, time)) << seed;
    }
  }
  EXPECT_GT(nearest, 0.3);  // and the bound is not idle
  EXPECT_GT(resonant, 10);
}

// The forcing carried on by the addition theorem, over a chatter's worth of flights: 4e-16 each.
TEST(Forcing, TurnsWithoutDrifting) {
  const Scene scene = paper::figure2();
  const auto mode = build_contact_mode<4>(scene, Held(2, 0));
  State<4> state;
  set_lanes(state, scene, mode, start_of(scene));
  State<4> exact = state;
  double time = 0.0;
  for (const double tau : {0.9, 0.8, 0.5, 0.1, 1e-3, 1e-9, 0.0, 0.7, 5.0, 0.83}) {
    time += tau;
    state.now.phase = exact.now.phase = time;
    turn_forcing(state, scene, tau);
    set_forcing(exact, scene);
    EXPECT_LT((state.value - exact.value).abs().maxCoeff(), 5e-15) << tau;
    EXPECT_LT((state.slope - exact.slope).abs().maxCoeff(), 5e-15) << tau;
  }
}

// The return of a mass against the search for any first root.
TEST(FirstReturn, IsTheFirstRoot) {
  Counters quick, thorough;
  int steps = 0;
  for (unsigned seed = 1; seed <= 2000; ++seed) {
    Polynomial gap;
    const double bend = 0.6 * std::abs(std::sin(seed));
    gap.coefficient[1] = 0.8;
    gap.coefficient[2] = -1.0;
    for (std::size_t n = 3; n <= 11; ++n)
      gap.coefficient[n] = std::pow(bend, static_cast<double>(n - 2)) *
                           std::cos(seed * static_cast<double>(n)) / 3.0;
    end_at(gap, 11);
    const auto root = first_return(gap, quick), expected = first_root(gap, 1, 1.0, thorough);
    ASSERT_EQ(root.has_value(), expected.has_value()) << seed;
    if (!root) continue;
    EXPECT_NEAR(root->at, expected->at, 1e-15) << seed;
    EXPECT_NEAR(root->slope, expected->slope, 4e-15) << seed;
    ++steps;
  }
  EXPECT_GT(steps, 1000);
  EXPECT_LT(quick.root_iterations, 2.5 * steps);
}

}  // namespace
