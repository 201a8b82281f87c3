// The stroboscopic map, its exact derivative, and Newton's method on it.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <Eigen/SVD>

#include "reference/scenes/paper_scenes.hpp"
#include "vibro_impact/analysis/analysis.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace {

using namespace vibro_impact;

Eigen::VectorXd coordinates_of(const MotionState &motion) {
  const std::vector<double> z = coordinates(motion);
  return Eigen::Map<const Eigen::VectorXd>(z.data(), static_cast<Eigen::Index>(z.size()));
}

Eigen::MatrixXd dense(const Matrix &matrix) {
  Eigen::MatrixXd copy(matrix.rows, matrix.columns);
  for (std::size_t i = 0; i < matrix.rows; ++i)
    for (std::size_t j = 0; j < matrix.columns; ++j)
      copy(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = matrix(i, j);
  return copy;
}

double largest(const Eigen::MatrixXd &matrix) {
  return matrix.cwiseAbs().maxCoeff();
}

int rank(const Eigen::MatrixXd &matrix) {
  const Eigen::VectorXd values = matrix.jacobiSvd().singularValues();
  return static_cast<int>((values.array() > 1e-10 * values(0)).count());
}

MotionState section_after(const Scene &scene, int periods) {
  return at_quiet_phase(scene, settled(scene, periods));
}

// A mass that sticks once per period has forgotten everything: two of four dimensions remain.
TEST(Derivative, StickingTakesItsRank) {
  const Scene scene = paper::figure2();
  const MotionState at = section_after(scene, 30);
  ASSERT_EQ(free_coordinates(at.held).size(), 4u);
  const Matrix derivative = stroboscopic_map_and_derivative(scene, at, 1).derivative;
  EXPECT_EQ(rank(dense(derivative)), 2);
  const std::vector<std::complex<double>> multipliers = floquet_multipliers(derivative, at.held);
  EXPECT_LT(std::abs(multipliers.at(2)), 1e-10);
  EXPECT_LT(std::abs(multipliers.at(0)), 1.0);
}

// The damping takes volume at the rate trace(C), every impact a factor r^2 (r for the velocity, and
// r for the time scale across the surface).
TEST(Derivative, WithoutStickingTakesVolumeByDampingAndImpacts) {
  const Scene scene = paper::stops_of_different_sign(0.6);
  const MotionState at = section_after(scene, 200);
  const StroboscopicImage image = stroboscopic_map_and_derivative(scene, at, 1);
  EXPECT_EQ(image.chatter_error, 0.0);
  EventRecorder recorder;
  stroboscopic_map(scene, at, 1, {}, recorder);
  const double contraction =
      std::pow(scene.restitution, 2.0 * static_cast<double>(recorder.events.size())) *
      std::exp(-0.3 * Clock(scene.omega).period);
  // Rounding of a determinant whose factors are of size one to four.
  EXPECT_NEAR(dense(image.derivative).determinant() / contraction, 1.0, 1e-10);
}

// What `stroboscopic_map` rests on: a run that is taken up again inside a sticking phase goes on as
// the undivided run does. Rounding of a few events: 1e-13.
TEST(StroboscopicMap, RunTakenUpInAStickingPhaseGoesOnUnchanged) {
  const Scene scene = paper::figure4a();
  const double period = Clock(scene.omega).period;
  const Outcome inside = simulate(scene, 60.0 * period + 14.7);
  ASSERT_EQ(inside.state.held, (Held{-1, 0}));
  const double end = 61.0 * period;
  const MotionState whole = simulate(scene, end).state;
  const MotionState resumed = simulate_from(scene, inside.state, end, {}).state;
  EXPECT_LT(largest(coordinates_of(whole) - coordinates_of(resumed)), 1e-13);
}

TEST(Newton, FindsTheOrbitOfFigure2FromFivePeriods) {
  const Scene scene = paper::figure2();
  const PeriodicOrbit orbit = find_periodic_orbit(scene, section_after(scene, 5));
  ASSERT_TRUE(orbit.converged);
  EXPECT_LT(orbit.residuals.size(), 6u);
  EXPECT_TRUE(orbit.stable());
  // The settled run, at the same section. Its rounding over 150 periods is that of one: the motion
  // forgets.
  const Outcome settled_run = require_complete(
      simulate(scene, time_of({150, orbit.state.instant.phase}, Clock(scene.omega)), {}));
  EXPECT_LT(largest(coordinates_of(settled_run.state) - coordinates_of(orbit.state)), 1e-11);
  EXPECT_LT(10 * orbit.expansions, settled_run.counters.expansions);
}

// From farther away: each residual is bounded by a constant times the square of the one before,
// until rounding. The constant is the curvature of the map, some tens.
TEST(Newton, ConvergesQuadratically) {
  for (double omega : {0.28, 0.6}) {
    const Scene scene = paper::stops_of_different_sign(omega);
    MotionState start = section_after(scene, 150);
    for (double &x : start.displacement) x *= 0.99;
    const PeriodicOrbit orbit = find_periodic_orbit(scene, start);
    ASSERT_TRUE(orbit.converged) << omega;
    EXPECT_GT(orbit.residuals.front(), 1e-4);
    for (std::size_t k = 1; k < orbit.residuals.size(); ++k)
      EXPECT_LT(orbit.residuals[k],
                std::max(1e-13, 100.0 * orbit.residuals[k - 1] * orbit.residuals[k - 1]));
  }
}

// A chain without stops: the orbit is the steady response, the multipliers exp(lambda T).
TEST(Newton, OfALinearChainTakesOneStepAndGivesItsMultipliers) {
  Scene scene = paper::figure2();
  scene.stops.clear();
  MotionState start = start_of(scene);
  const PeriodicOrbit orbit = find_periodic_orbit(scene, start);
  ASSERT_TRUE(orbit.converged);
  EXPECT_LE(orbit.residuals.size(), 3u);
  const double lambda = (3.0 - std::sqrt(5.0)) / 2.0;
  // The slow mode decays as exp(-zeta omega t) = exp(-c lambda t / 2).
  EXPECT_NEAR(std::abs(orbit.multipliers.at(0)),
              std::exp(-0.05 * lambda * Clock(scene.omega).period), 1e-13);
}

// One line for each way in which the search can end without an orbit.
TEST(Newton, SaysWhyItDidNotConverge) {
  const auto why_not = [](const Scene &scene, const MotionState &guess, int most = 20) {
    const PeriodicOrbit orbit =
        find_periodic_orbit(scene, guess, 1, {.run = {}, .max_iterations = most});
    EXPECT_FALSE(orbit.converged);
    EXPECT_EQ(orbit.why_not.find('\n'), std::string::npos);
    return orbit.why_not;
  };
  const auto starts = [](const std::string &text, const std::string &with) {
    EXPECT_EQ(text.substr(0, with.size()), with) << text;
  };
  const Scene scene = paper::figure2();
  starts(why_not(scene, section_after(scene, 2), 0), "residual = ");
  MotionState held = section_after(scene, 30);
  held.held = {-1, 0};  // that mass is let go, and does not stick at this phase
  starts(why_not(scene, held),
         "iterate 0: returns with other masses held (-) than it starts with (1)");
  // A free mass without damping and forcing, at rest: every state is an orbit's, or none.
  Scene free{.mass = {1.0}, .stiffness = {0.0}, .omega = 1.0, .displacement = {0.0}};
  MotionState moving = start_of(free);
  moving.velocity = {0.1};
  starts(why_not(free, moving), "iterate 0: a Floquet multiplier is 1");
  // Far below its stop a mass on a spring moves, for a short period, as if there were none: that
  // orbit, rest at 0, is beyond the stop.
  const Scene below{.mass = {1.0},
                    .stiffness = {1.0},
                    .omega = 50.0,
                    .stops = {{1, Side::upper, -1.0}},
                    .displacement = {-2.0}};
  starts(why_not(below, start_of(below)), "iterate 1: a mass is beyond its stop");
  EXPECT_TRUE(find_periodic_orbit(scene, section_after(scene, 30)).why_not.empty());
}

}  // namespace
