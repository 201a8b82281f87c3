// The greatest Lyapunov exponent, by Floquet multipliers and by the growth of tangents.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <vector>

#include "reference/scenes/paper_scenes.hpp"
#include "vibro_impact/analysis/analysis.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace {

using namespace vibro_impact;

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
  const MotionState start = vibro_impact::settled(scene, 100);
  EXPECT_NEAR(mean_growth(scene, start, 100).exponent, expected,
              std::log(10.0) / (100 * Clock(scene.omega).period));
}

// Brought back to length 1 every few periods, a change grows as it would without: in a chaotic
// motion and in one that sticks, where the section may lie within a chatter.
TEST(Lyapunov, ScalingDoesNotChangeTheGrowth) {
  constexpr int periods = 20;
  for (const double omega : {0.69, 0.6, 0.665, 0.28}) {
    const Scene scene = paper::figure3(omega);
    const MotionState start = at_quiet_phase(scene, vibro_impact::settled(scene, 60));
    const Matrix map = stroboscopic_map_and_derivative(scene, start, periods).derivative;
    double before = 0.0, after = 0.0;
    for (std::size_t i = 0; i < 4; ++i) {
      double sum = 0.0;
      for (std::size_t k = 0; k < 4; ++k) sum += start.held[k % 2] == 0 ? map(i, k) : 0.0;
      after += sum * sum;
      before += start.held[i % 2] == 0 ? 1.0 : 0.0;
    }
    const double duration = periods * Clock(omega).period,
                 expected = 0.5 * std::log(after / before) / duration;
    // Rounding, which grows no faster than the change itself; contracting directions cancel in the
    // sum of the columns, which leaves some digits less where all contract.
    EXPECT_NEAR(mean_growth(scene, start, periods).exponent, expected, 1e-8) << omega;
  }
}

// Above 0.6, where a diagram from rest shows bands: chaos, and a transient that is slow.
TEST(Lyapunov, TellsChaosFromASlowTransient) {
  RecordOptions options;
  options.lyapunov = true;
  options.counted = 200;
  const auto exponent = [&](double omega) {
    const OrbitRecord record = record_of(paper::figure3(omega), options);
    EXPECT_EQ(record.period, 0) << omega;
    return *record.lyapunov;
  };
  EXPECT_GT(exponent(0.69), 0.01);
  EXPECT_GT(exponent(0.698), 0.01);
  EXPECT_LT(exponent(0.6325), -1e-4);
}

// Points of the atlas where a mean over 40 periods has another sign than over 2,000: chaotic
// transients, and exponents near zero. The sign is right, or not said; a motion with a negative
// exponent that settles late may go on until it has.
TEST(Lyapunov, TheSignOfAMotionThatHasNotSettledIsRightOrNotSaid) {
  struct Point {
    double omega, restitution, amplitude;
    int sign;  // over 2,000 periods
  };
  RecordOptions options;
  options.lyapunov = true;
  options.settle.longest = 200;
  int decided = 0;
  for (const auto &[omega, restitution, amplitude, sign] : {Point{0.672038, 0.7, 0.776122, 1},
                                                            {0.621387, 0.7, 0.44802, -1},
                                                            {0.361809, 0.7, 0.0773428, 1},
                                                            {0.711957, 0.7, 0.697854, 1},
                                                            {0.71938, 0.7, 0.685798, 1},
                                                            {0.717384, 0.7, 0.673214, 1},
                                                            {0.719235, 0.7, 0.725939, 1}}) {
    Scene scene = paper::figure3(omega);
    scene.restitution = restitution;
    scene.amplitude[0] = amplitude;
    const OrbitRecord record = record_of(scene, options);
    EXPECT_EQ(record.period, 0) << omega;
    EXPECT_GE(record.lyapunov.value_or(0.0) * sign, 0.0) << omega;
    decided += record.lyapunov ? 1 : 0;
  }
  EXPECT_GE(decided, 1);
  options.longest_if_stable = 1000;
  Scene slow = paper::figure3(0.528341);
  slow.amplitude[0] = 0.386047;
  EXPECT_EQ(record_of(slow, options).period, 2);
  EXPECT_GT(record_of(slow, options).work.settling, 200 + 400);
}

}  // namespace
