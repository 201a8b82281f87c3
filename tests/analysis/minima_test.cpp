// The natural modes, and the least pressing force, the least gap and the response of a motion.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "reference/scenes/paper_scenes.hpp"
#include "tests/support/random_scenes.hpp"
#include "vibro_impact/analysis/analysis.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace {

using namespace vibro_impact;

// One mass that its spring presses into a lower stop at s = 0.8 with k s - A cos(Omega t - shift) >
// 0: the least force is k s - A, where the angle is the shift. The force has a few roundings.
TEST(LeastPressingForce, OfAHeldMassIsThatOfTheForcing) {
  for (const double shift : {0.0, 0.5, 1.5}) {
    const Scene scene{.mass = {2.0},
                      .stiffness = {1.5},
                      .beta = 0.1,
                      .amplitude = {0.7 * std::cos(shift)},
                      .sine = {0.7 * std::sin(shift)},
                      .omega = 0.9,
                      .stops = {{1, Side::lower, 0.8}},
                      .displacement = {0.8}};
    MotionState start = start_of(scene);
    start.instant.phase = 2.0;
    start.held = {-1};
    const auto least = least_pressing_force(scene, start, scene.stops[0]);
    ASSERT_TRUE(least.has_value());
    EXPECT_NEAR(least->value, 1.5 * 0.8 - 0.7, 1e-15);
    EXPECT_NEAR(std::cos(scene.omega * least->at.instant.phase - shift), 1.0, 1e-15);
    EXPECT_FALSE(least_pressing_force(scene, start, {1, Side::upper, 0.8}).has_value());
  }
}

// One mass in its steady motion of amplitude A / |k - m Omega^2|, without damping: the least gap to
// a stop that the scene does not have is the distance to the turning point.
TEST(LeastGap, OfASteadyMotionIsTheDistanceToItsTurningPoint) {
  Scene scene{.mass = {1.0}, .stiffness = {1.0}, .amplitude = {0.3}, .omega = 0.5};
  const double amplitude = 0.3 / (1.0 - 0.25);
  scene.displacement = {amplitude};
  MotionState start = start_of(scene);
  start.instant.phase = 1.0;
  start.displacement = {amplitude * std::cos(0.5)};
  start.velocity = {-0.5 * amplitude * std::sin(0.5)};
  const auto upper = least_gap(scene, start, {1, Side::upper, 0.6});
  const auto lower = least_gap(scene, start, {1, Side::lower, -0.5});
  ASSERT_TRUE(upper.has_value() && lower.has_value());
  EXPECT_NEAR(upper->value, 0.6 - amplitude, 2e-15);
  EXPECT_NEAR(lower->value, 0.5 - amplitude, 2e-15);
}

// A damped oscillation turns at ever smaller displacements, so the first turning point is nearest
// to the stop. At Omega = 0.6 mass 2 of Figure 3 hits its stop whenever it comes near, and an
// impact is no turning point.
TEST(LeastGap, IsTheLeastOfSeveralMinima) {
  const Scene scene{
      .mass = {1.0}, .stiffness = {9.0}, .beta = 0.02, .omega = 1.0, .velocity = {1.0}};
  const auto least = least_gap(scene, start_of(scene), {1, Side::upper, 1.0});
  ASSERT_TRUE(least.has_value());
  const double decay = 0.09, frequency = std::sqrt(9.0 - decay * decay);
  EXPECT_NEAR(least->at.instant.phase, std::atan(frequency / decay) / frequency, 1e-14);
  const Scene impacting = paper::figure3(0.6);
  const MotionState start = state_after_periods(impacting, 60);
  EXPECT_FALSE(least_gap(impacting, start, impacting.stops[1]).has_value());
}

// K phi = lambda M phi and phi^T M phi = 1, where mass 3 is held.
TEST(NaturalModes, SolveTheEigenvalueProblem) {
  const Scene scene{.mass = {1.0, 2.0, 0.5, 1.0, 3.0}, .stiffness = {4.0, 1.0, 2.0, 0.25, 0.5}};
  const Held held{0, 0, 1, 0, 0};
  const NaturalModes modes = natural_modes(scene, held);
  ASSERT_EQ(modes.lambda.size(), 4u);
  for (std::size_t k = 0; k < 4; ++k) {
    double modal_mass = 0.0;
    for (std::size_t i = 0; i < 5; ++i) {
      const double shape = modes.shape(i, k);
      modal_mass += scene.mass[i] * shape * shape;
      if (held[i] != 0) {
        EXPECT_EQ(shape, 0.0);
        continue;
      }
      double force = scene.stiffness[i] * ((i > 0 ? modes.shape(i - 1, k) : 0.0) - shape);
      if (i < 4) force += scene.stiffness[i + 1] * (modes.shape(i + 1, k) - shape);
      EXPECT_NEAR(-force, modes.lambda[k] * scene.mass[i] * shape, 1e-14);
    }
    EXPECT_NEAR(modal_mass, 1.0, 1e-14);
  }
}

// The masses and links of these chains differ by many orders of magnitude. The errors of a solver
// are then larger than its least eigenvalues, and disturb their order.
TEST(NaturalModes, AreInAscendingOrder) {
  for (unsigned seed = 1; seed <= 300; ++seed) {
    const Scene scene = vibro_impact::testing::graded_chain(seed);
    const std::vector<double> lambda = natural_modes(scene, Held(scene.mass.size())).lambda;
    EXPECT_TRUE(std::is_sorted(lambda.begin(), lambda.end())) << seed;
    // The rigid-body mode of a free chain comes first.
    EXPECT_EQ(lambda.front() == 0.0, scene.stiffness.front() == 0.0) << seed;
  }
}

// A ball of weight 1 that falls from 1/2 onto a table at 0 without loss: the mean of x^2 is 2/15.
// 2e-7: Simpson's rule errs by the fourth power of the interval. 2e-8 was measured.
TEST(Response, OfABouncingBallIsThatOfItsParabolas) {
  const Scene scene{.mass = {1.0},
                    .stiffness = {0.0},
                    .constant = {-1.0},
                    .omega = 0.0,
                    .restitution = 1.0,
                    .stops = {{1, Side::lower, 0.0}},
                    .displacement = {0.5}};
  ResponseRecorder recorder(scene, 0.0, 8.0);
  require_complete(simulate(scene, 8.0, recorder));
  const Response response = recorder.responses().at(0);
  EXPECT_NEAR(response.rms, std::sqrt(2.0 / 15.0), 2e-7);
  EXPECT_EQ(response.lowest, 0.0);
  EXPECT_NEAR(response.highest, 0.5, 1e-15);
}

}  // namespace
