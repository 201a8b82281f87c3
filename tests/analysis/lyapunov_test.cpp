// The greatest Lyapunov exponent, by Floquet multipliers and by the growth of tangents.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>
#include <utility>
#include <vector>

#include "reference/paper_scenes.hpp"
#include "vibro_impact/analysis/analysis.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace {

using namespace vibro_impact;

// A point of the plane of frequency and amplitude of the atlas.
Scene at_point(double omega, double amplitude) {
  Scene scene = paper::figure3(omega);
  scene.amplitude[0] = amplitude;
  return scene;
}

// The growth of a change by the derivatives of the stroboscopic map alone, eight periods at a time:
// the exponent over as many periods as asked for, whether or not its sign is certain.
double growth_over(int periods, const Scene &scene, MotionState at) {
  std::vector<double> change;
  for (std::size_t i = 0; i < 4; ++i) change.push_back(at.held[i % 2] == 0 ? 1.0 : 0.0);
  const auto length_of = [](const std::vector<double> &v) {
    return std::hypot(std::hypot(v[0], v[1]), std::hypot(v[2], v[3]));
  };
  double logarithm = -std::log(length_of(change));
  for (int done = 0; done < periods;) {
    const int next = std::min(8, periods - done);
    const StroboscopicImage image = stroboscopic_map_and_derivative(scene, at, next);
    std::vector<double> moved(4, 0.0);
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t k = 0; k < 4; ++k) moved[i] += image.derivative(i, k) * change[k];
    const double length = length_of(moved);
    logarithm += std::log(length);
    for (std::size_t i = 0; i < 4; ++i) change[i] = moved[i] / length;
    at = image.state;
    done += next;
  }
  return logarithm / (periods * Clock(scene.omega).period);
}

// A single mass that sticks once a period has forgotten where it came from.
TEST(Lyapunov, IsMinusInfinityWhereEveryChangeDiesOut) {
  const Scene scene{.mass = {1.0},
                    .stiffness = {1.0},
                    .beta = 0.1,
                    .amplitude = {0.5},
                    .omega = 0.28,
                    .restitution = 0.7,
                    .stops = {{1, Side::lower, -0.3}},
                    .displacement = {0.0},
                    .velocity = {0.0}};
  RecordOptions options;
  options.lyapunov = true;
  const OrbitRecord record = record_of(scene, options);
  ASSERT_GT(record.counts.sticks[0], 0);
  EXPECT_EQ(record.lyapunov.value(), -INFINITY);
}

// Far from its stops the chain is linear: the slower of its modes decays at beta lambda_1 / 2.
TEST(Lyapunov, OfALinearMotionIsTheSlowestDecay) {
  Scene scene = paper::figure2();
  for (Stop &stop : scene.stops) stop.position *= 1e3;
  const double expected = -0.05 * (3.0 - std::sqrt(5.0)) / 2.0;
  RecordOptions options;
  options.lyapunov = true;
  options.settle.longest = 2000;
  const OrbitRecord record = record_of(scene, options);
  ASSERT_EQ(record.period, 1);
  EXPECT_NEAR(*record.lyapunov, expected, 1e-12);  // rounding of the multipliers
  // By growth the angle of the change matters, a factor of order 1 of its length.
  EXPECT_NEAR(mean_growth(scene, state_after_periods(scene, 100), 100).exponent, expected,
              std::log(10.0) / (100 * Clock(scene.omega).period));
}

// Brought back to length 1 every few periods, a change grows as it does by the map of all of them:
// in a chaotic motion and in one that sticks, where the section may lie within a chatter.
TEST(Lyapunov, ScalingDoesNotChangeTheGrowth) {
  for (const double omega : {0.69, 0.6, 0.665, 0.28}) {
    const Scene scene = paper::figure3(omega);
    const MotionState start = at_quiet_phase(scene, state_after_periods(scene, 60));
    // Rounding, which grows no faster than the change itself; contracting directions cancel in the
    // sum of the columns, which leaves some digits less where all contract.
    EXPECT_NEAR(mean_growth(scene, start, 20).exponent, growth_over(20, scene, start), 1e-8)
        << omega;
  }
}

// Points that do not settle within 200 periods, chaotic and slow; over 40 periods the growth at
// half of them has the wrong sign. What is said is the sign of 2,000 periods.
TEST(Lyapunov, TheSignOfAMotionThatHasNotSettledIsRight) {
  RecordOptions options;
  options.lyapunov = true;
  options.settle.longest = 200;
  int positive = 0, negative = 0;
  for (const auto &[omega, amplitude] : {std::pair{0.69, 0.5},
                                         {0.748605, 0.924352},
                                         {0.744302, 1.086931},
                                         {0.6325, 0.5},
                                         {0.689273, 0.611763},
                                         {0.777921, 1.063141}}) {
    const Scene scene = at_point(omega, amplitude);
    const OrbitRecord record = record_of(scene, options);
    ASSERT_EQ(record.period, 0) << omega;
    ASSERT_TRUE(record.lyapunov) << omega;
    const double over = growth_over(2000, scene, at_quiet_phase(scene, record.state));
    EXPECT_GT(*record.lyapunov * over, 0.0) << omega;
    ++(over > 0.0 ? positive : negative);
  }
  EXPECT_EQ(positive, 3);
  EXPECT_EQ(negative, 3);
}

// The numbers of lib/README.md, "Settled": of random points in the plane of frequency and amplitude
// those that do not settle within 200 periods, against the growth over 2,000. Some minutes:
//   lyapunov_test --gtest_also_run_disabled_tests --gtest_filter='*Survey*'
TEST(Lyapunov, DISABLED_SurveyOfMotionsThatHaveNotSettled) {
  std::mt19937 random(20060401);
  std::vector<Scene> scenes;
  for (int k = 0; k < 600; ++k) {
    const double omega = std::uniform_real_distribution<double>(0.2, 0.8)(random);
    scenes.push_back(at_point(omega, std::uniform_real_distribution<double>(0.02, 1.2)(random)));
  }
  int points = 0, wrong_over_40 = 0, wrong = 0, not_decided = 0;
  const auto growths = [&](std::size_t k) -> std::vector<double> {
    const Scene &scene = scenes[k];
    const SettledMotion motion = settle(scene, start_of(scene), {.longest = 200});
    if (motion.period > 0) return {};
    const MotionState start = at_quiet_phase(scene, motion.state);
    const Growth growth = mean_growth(scene, start, 1000);
    return {growth_over(2000, scene, start), growth_over(40, scene, start),
            growth.sign_is_certain ? growth.exponent : 0.0};
  };
  sweep(scenes.size(), growths, [&](std::size_t k, const std::vector<double> &row) {
    if (row.empty()) return;
    ++points;
    wrong_over_40 += row[0] * row[1] < 0.0 ? 1 : 0;
    wrong += row[0] * row[2] < 0.0 ? 1 : 0;
    not_decided += row[2] == 0.0 ? 1 : 0;
    std::printf("omega %.6f A1 %.6f: %9.6f over 2000 periods, %9.6f over 40, said %9.6f\n",
                scenes[k].omega, scenes[k].amplitude[0], row[0], row[1], row[2]);
  });
  std::printf("%d points: wrong sign over 40 periods %d, said %d, not decided %d\n", points,
              wrong_over_40, wrong, not_decided);
}

// A motion with a negative exponent that settles late may go on until it has.
TEST(Lyapunov, OfAMotionThatSettlesLateLetsItGoOn) {
  RecordOptions options;
  options.lyapunov = true;
  options.settle.longest = 200;
  options.longest_if_stable = 1000;
  const OrbitRecord record = record_of(at_point(0.528341, 0.386047), options);
  EXPECT_EQ(record.period, 2);
  EXPECT_GT(record.work.settling, 200 + 400);
}

}  // namespace
