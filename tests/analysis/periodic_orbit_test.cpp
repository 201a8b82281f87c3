// Periodic orbits by Newton's method on the stroboscopic map. tangent_test has its derivative.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "reference/scenes/extreme_scenes.hpp"
#include "reference/scenes/paper_scenes.hpp"
#include "vibro_impact/analysis/analysis.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace {

using namespace vibro_impact;

MotionState section_after(const Scene &scene, int periods) {
  return at_quiet_phase(scene, state_after_periods(scene, periods));
}

// From five periods, or from farther away: each residual is bounded by a constant times the square
// of the one before, until rounding. The constant is the curvature of the map, some tens. The
// rounding of a settled run over 400 periods is that of one, because the motion contracts.
TEST(Newton, ConvergesQuadraticallyToTheSettledMotion) {
  for (const auto &[omega, periods, share, least] :
       {std::tuple{0.2, 5, 1.0, 1e-13}, {0.28, 150, 0.99, 1e-4}, {0.6, 150, 0.99, 1e-4}}) {
    const Scene scene = paper::figure3(omega);
    MotionState start = section_after(scene, periods);
    for (double &x : start.displacement) x *= share;
    const PeriodicOrbit orbit = find_periodic_orbit(scene, start);
    ASSERT_TRUE(orbit.converged) << omega;
    EXPECT_TRUE(orbit.stable()) << omega;
    EXPECT_GT(orbit.residuals.front(), least) << omega;
    EXPECT_LT(orbit.residuals.size(), 6u) << omega;
    for (std::size_t k = 1; k < orbit.residuals.size(); ++k)
      EXPECT_LT(orbit.residuals[k],
                std::max(1e-13, 100.0 * orbit.residuals[k - 1] * orbit.residuals[k - 1]));
    const double settled = time_of({400, orbit.state.instant.phase}, Clock(omega));
    const std::vector<double> z = coordinates(orbit.state),
                              run = coordinates(simulate(scene, settled).state);
    for (std::size_t i = 0; i < z.size(); ++i) EXPECT_NEAR(z[i], run[i], 1e-11) << omega;
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
  // An undamped oscillator at its resonance: rounding alone keeps a multiplier from 1.
  Scene resonant{.mass = {1.0}, .stiffness = {1.0}, .amplitude = {0.5}, .omega = 1.0};
  for (const double start : {0.0, 1.0, 1e4})  // small and large beside the forced part
    for (const double amplitude : {0.5, 1e-4}) {
      resonant.displacement = {start};
      resonant.amplitude = {amplitude};
      starts(why_not(resonant, at_quiet_phase(resonant, start_of(resonant))),
             "iterate 0: a Floquet multiplier is 1");
    }
  // Far below its stop a mass on a spring moves, for a short period, as if there were none: that
  // orbit, rest at 0, is beyond the stop.
  const Scene below = extremes::one_mass(0.0, 0.0, 50.0, 1.0, -1.0, -2.0);
  starts(why_not(below, start_of(below)), "iterate 1: a mass is beyond its stop");
  EXPECT_TRUE(find_periodic_orbit(scene, section_after(scene, 30)).why_not.empty());
}

// Next to the resonance the amplitude is A / (1 - omega^2), to the rounding of the map over the
// distance of the multipliers from 1.
TEST(Newton, FindsTheOrbitNextToAResonance) {
  for (const double distance : {1e-3, 1e-6, 1e-9}) {
    const Scene scene{
        .mass = {1.0}, .stiffness = {1.0}, .amplitude = {0.5}, .omega = 1.0 - distance};
    const PeriodicOrbit orbit = find_periodic_orbit(scene, at_quiet_phase(scene, start_of(scene)));
    ASSERT_TRUE(orbit.converged) << orbit.why_not;
    const double size =
                     std::hypot(orbit.state.displacement[0], orbit.state.velocity[0] / scene.omega),
                 amplitude = 0.5 / (distance * (2.0 - distance));
    EXPECT_NEAR(size / amplitude, 1.0, 1e-14 / distance);
    const MotionState after = stroboscopic_map(scene, orbit.state, 1);
    EXPECT_NEAR(after.displacement[0], orbit.state.displacement[0], 2e-13 * amplitude);
  }
}

}  // namespace
