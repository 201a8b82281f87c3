// What a survey says of a gap or a hold force, and the crossing found on the lanes, against the
// closed form of the flow.
#include <gtest/gtest.h>

#include "random_scenes.hpp"
#include "vibro_impact/first_event.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace {

using namespace vibro_impact;
using vibro_impact::testing::Draw;
constexpr int dynamic = Eigen::Dynamic;

// Two or three masses in motion; every second time the first one is held at its stop.
struct Moving {
  Scene scene;
  ContactMode<dynamic> mode;
  State<dynamic> state;
  Expansion expansion;
  Counters counters;
  bool held;

  explicit Moving(unsigned seed) {
    Draw draw{std::mt19937(seed)};
    const auto masses = static_cast<std::size_t>(2 + draw.below(2));
    held = seed % 2 == 1;
    for (std::size_t i = 0; i < masses; ++i) {
      scene.mass.push_back(draw.uniform(0.5, 2.0));
      scene.stiffness.push_back(draw.uniform(0.5, 2.0));
      scene.amplitude.push_back(draw.uniform(-0.5, 0.5));
    }
    scene.beta = seed % 3 == 0 ? 0.0 : draw.uniform(0.0, seed % 3 == 1 ? 0.3 : 5.0);
    scene.omega = draw.uniform(0.1, 1.0);
    scene.stops = {{1, Side::upper, draw.uniform(0.0, 0.3)}};
    Held how(masses, 0);
    how[0] = held ? 1 : 0;
    mode = build_contact_mode<dynamic>(scene, how);
    MotionState motion = start_of(scene);
    motion.instant.phase = draw.uniform(0.0, 5.0);
    for (Eigen::Index i = 0; i < motion.displacement.size(); ++i) {
      motion.displacement(i) = draw.uniform(-0.4, 0.4);
      motion.velocity(i) = draw.uniform(-0.4, 0.4);
    }
    motion.displacement(0) = held ? scene.stops[0].position : draw.uniform(-0.4, 0.0);
    if (held) motion.velocity(0) = 0.0;
    state.now = motion.instant;
    set_lanes(state, scene, mode, motion);
    state.stops = {{scene.stops[0].position - motion.displacement(0), -motion.velocity(0), 0, 0.0}};
    expand(mode, state.value, state.slope, max_reach / mode.fastest, expansion, counters);
  }
  const Reading<dynamic> &reading() const {
    return held ? mode.closed[0].press : mode.open[0].gap;
  }
  // The reading and the lanes u of the expansion later, in closed form.
  double at(double u, Eigen::ArrayXd &value, Eigen::ArrayXd &slope) const {
    flow(mode, scene, state.value, state.slope, u * expansion.span, value, slope);
    set_forcing(mode, scene, state.now.phase + u * expansion.span, value, slope);
    return reading()(value, slope);
  }
  double at(double u) const {
    Eigen::ArrayXd value, slope;
    return at(u, value, slope);
  }
  Survey survey_of_it() {
    return survey(mode, reading(), state.value, state.slope, expansion, held ? 0 : 1, counters);
  }
};

// Every statement holds at 400 points, and surveys are worth their price: few are undecided.
TEST(Survey, WhatItSaysIsSo) {
  int positive = 0, crossing = 0, undecided = 0;
  for (unsigned seed = 0; seed < 3000; ++seed) {
    Moving moving(seed);
    if (!(moving.at(0.0) > 0.0)) continue;
    const Survey seen = moving.survey_of_it();
    if (seen.outlook == Outlook::undecided) {
      ++undecided;
      continue;
    }
    int changes = 0;
    double before = moving.at(0.0);
    for (int k = 1; k <= 400; ++k) {
      const double now = moving.at(k / 400.0);
      if ((now > 0.0) != (before > 0.0)) {
        ++changes;
        EXPECT_NEAR(seen.crossing, k / 400.0, 0.04) << seed;
      }
      before = now;
    }
    EXPECT_EQ(changes, seen.outlook == Outlook::crosses_once ? 1 : 0) << seed;
    ++(changes == 1 ? crossing : positive);
  }
  EXPECT_GT(positive, 500);
  EXPECT_GT(crossing, 500);
  EXPECT_LT(undecided, (positive + crossing) / 4);
}

// The lanes at the crossing, in closed form; 1e-14 of the largest of them, or of one: rounding.
TEST(Crossing, LiesAtTheRootOfTheClosedForm) {
  int found = 0, given_up = 0;
  for (unsigned seed = 0; seed < 3000; ++seed) {
    Moving moving(seed);
    if (!(moving.at(0.0) > 0.0)) continue;
    const Survey seen = moving.survey_of_it();
    if (seen.outlook != Outlook::crosses_once || moving.mode.any_resonant) continue;
    Crossing<dynamic> crossing;
    if (!find_crossing(moving.state, moving.reading(), seen, moving.expansion, moving.scene,
                       Clock(moving.scene.omega), crossing, moving.counters)) {
      ++given_up;
      continue;
    }
    ++found;
    Eigen::ArrayXd value, slope;
    EXPECT_NEAR(moving.at(crossing.u, value, slope), 0.0, 1e-14) << seed;
    const double size = std::max({1.0, value.abs().maxCoeff(), slope.abs().maxCoeff()});
    EXPECT_LT((value - crossing.value).abs().maxCoeff(), 1e-14 * size) << seed;
    EXPECT_LT((slope - crossing.slope).abs().maxCoeff(), 1e-14 * size) << seed;
    const double h = 1e-4, rate = (moving.at(crossing.u + h) - moving.at(crossing.u - h)) /
                                  (2.0 * h * moving.expansion.span);
    EXPECT_NEAR(crossing.rate, rate, 1e-6) << seed;
    EXPECT_LT(crossing.rate, 0.0);
  }
  EXPECT_GT(found, 500);
  EXPECT_LT(given_up, found / 4);
}

}  // namespace
