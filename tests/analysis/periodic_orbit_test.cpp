// Periodic orbits by Newton's method on the stroboscopic map. tangent_test has its derivative.
#include <gtest/gtest.h>

#include <algorithm>

#include "reference/scenes/paper_scenes.hpp"
#include "vibro_impact/analysis/analysis.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace {

using namespace vibro_impact;

MotionState section_after(const Scene &scene, int periods) {
  return at_quiet_phase(scene, state_after_periods(scene, periods));
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
  const std::vector<double> z = coordinates(orbit.state), run = coordinates(settled_run.state);
  for (std::size_t i = 0; i < z.size(); ++i) EXPECT_NEAR(z[i], run[i], 1e-11);
}

// From farther away: each residual is bounded by a constant times the square of the one before,
// until rounding. The constant is the curvature of the map, some tens.
TEST(Newton, ConvergesQuadratically) {
  for (double omega : {0.28, 0.6}) {
    const Scene scene = paper::figure3(omega);
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

// One line for each way in which the search can end without an orbit. An orbit that was not found
// is not stable, whatever the multipliers of its best iterate.
TEST(Newton, SaysWhyItDidNotConverge) {
  const auto why_not = [](const Scene &scene, const MotionState &guess, int most = 20) {
    const PeriodicOrbit orbit = find_periodic_orbit(scene, guess, 1, most);
    EXPECT_FALSE(orbit.converged);
    EXPECT_FALSE(orbit.stable());
    EXPECT_EQ(orbit.why_not.find('\n'), std::string::npos);
    return orbit.why_not;
  };
  const auto starts = [](const std::string &text, const std::string &with) {
    EXPECT_EQ(text.substr(0, with.size()), with) << text;
  };
  const Scene scene = paper::figure2();
  starts(why_not(scene, section_after(scene, 2), 0), "residual = ");
  MotionState held = section_after(scene, 30);
  held.held = {-1, 0};  // at this phase mass 2 sticks, and mass 1 does not
  starts(why_not(scene, held),
         "iterate 0: returns with other masses held (2) than it starts with (1)");
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
