// Families of periodic orbits followed by the speed of an impact: against published branches of a
// single oscillator, and against what the stroboscopic map says of the same orbits.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "reference/scenes/paper_scenes.hpp"
#include "tests/reference/published_vivid.hpp"
#include "vibro_impact/analysis/analysis.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace {

using namespace vibro_impact;
using Kind = Parameter::Kind;

// F at which the motion without impact grazes: its amplitude is 1.
double grazing_amplitude(double omega) {
  return std::hypot(1.0 - omega * omega, 0.04 * omega);
}

// The published amplitudes at these impact speeds are solved to 1e-10, the multipliers agree to
// 4e-8 over all 2616 rows of which these are a part.
TEST(ImpactFamily, AgreesWithThePublishedBranches) {
  ASSERT_EQ(published_vivid().size(), 48u);
  for (const VividRow &row : published_vivid()) {
    const ImpactOrbit orbit = vivid_orbit(row);
    EXPECT_TRUE(orbit.real) << row.name;
    EXPECT_NEAR(orbit.parameter, row.amplitude, 1e-10) << row.name;
    double nearest = INFINITY;
    for (const auto &multiplier : orbit.multipliers)
      nearest = std::min(nearest, std::abs(multiplier - row.multiplier));
    EXPECT_LT(nearest, 1e-7) << row.name;
  }
}

// From an attractor found by a run, down through the period doubling and through the grazing: at
// speed 0 the orbit is that without impact of amplitude 1, in closed form. Newton's method takes no
// more steps there than elsewhere.
TEST(ImpactFamily, IsFollowedThroughAPeriodDoublingAndThroughGrazing) {
  const ImpactFamily family = vivid_family(0.81, 0.36);
  const MotionState seed = at_quiet_phase(family.scene, settled(family.scene, 2000));
  const PeriodicOrbit attractor = find_periodic_orbit(family.scene, seed, 2);
  ASSERT_TRUE(attractor.converged && attractor.stable());
  const ImpactOrbit start = impact_orbit_of(family, attractor);
  EXPECT_NEAR(start.parameter, 0.36, 1e-13);
  const std::vector<ImpactOrbit> orbits = follow(family, start, -0.02, 0.01);
  ASSERT_EQ(orbits.back().speed, -0.02);
  EXPECT_LT(orbits.size(), 60u);
  int doublings = 0;
  for (std::size_t i = 1; i < orbits.size(); ++i) {
    EXPECT_LE(orbits[i].residuals.size(), 5u) << orbits[i].speed;
    EXPECT_EQ(orbits[i].real, orbits[i].speed > 0.0) << orbits[i].speed;
    const auto found = doubling_between(family, orbits[i - 1], orbits[i]);
    if (!found) continue;
    ++doublings;
    EXPECT_NEAR(found->multipliers[0].real(), -1.0, 1e-10);
    // The published row next to it, where the multiplier is off -1 by 3e-6 (its slope is 28).
    EXPECT_NEAR(found->parameter, vivid_row("PD 1").amplitude, 1e-6);
    EXPECT_NEAR(found->speed, vivid_row("PD 1").speed, 1e-5);
  }
  EXPECT_EQ(doublings, 1);
  const ImpactOrbit grazing = impact_orbit(family, orbits.back(), 0.0).value();
  EXPECT_NEAR(grazing.parameter, grazing_amplitude(0.81), 1e-13);
  EXPECT_TRUE(grazing.multipliers.empty());
  // Through the grazing F is smooth in the speed: its third difference is h^3 times its third
  // derivative, some units; a square root would leave a difference of first order.
  const double h = 1e-3;
  const auto at = [&](double speed) { return impact_orbit(family, grazing, speed)->parameter; };
  EXPECT_LT(std::abs(at(2 * h) - 2 * at(h) + 2 * at(-h) - at(-2 * h)), 100 * h * h * h);
}

// At 0.799 the branch leaves the grazing upwards, turns in a fold and is stable beyond it.
TEST(ImpactFamily, IsFollowedThroughAFold) {
  const ImpactFamily family = vivid_family(0.799, 0.363);
  const std::vector<ImpactOrbit> orbits = follow(family, vivid_orbit(vivid_row("SN 1")), 0.2, 0.02);
  const std::vector<ImpactOrbit> back = follow(family, orbits.front(), -0.01, 0.02);
  ASSERT_EQ(orbits.back().speed, 0.2);
  ASSERT_EQ(back.back().speed, -0.01);
  const auto fold = fold_between(family, orbits.back(), back.back());
  ASSERT_TRUE(fold.has_value());
  EXPECT_NEAR(fold->multipliers[0].real(), 1.0, 1e-9);
  // F is flat there: 1e-6 of the multiplier are 1e-12 of F.
  EXPECT_NEAR(fold->parameter, vivid_row("SN 1").amplitude, 1e-10);
  EXPECT_NEAR(fold->speed, vivid_row("SN 1").speed, 1e-4);
  EXPECT_GT(orbits.back().parameter, fold->parameter);
  EXPECT_LT(std::abs(orbits.back().multipliers[0]), 1.0);
  EXPECT_NEAR(impact_orbit(family, back.back(), 0.0)->parameter, grazing_amplitude(0.799), 1e-13);
  EXPECT_FALSE(doubling_between(family, orbits.front(), orbits.back()).has_value());
}

// Two masses, seven impacts a period, several at the stop of the one followed: the same orbit, the
// same multipliers and the inverse of the same derivative as from the stroboscopic map, whatever
// the parameter, also one of the stop itself. Rounding of a period, divided by dv/dp: 1e-9.
TEST(ImpactFamily, AgreesWithTheStroboscopicMap) {
  const Scene scene = paper::stops_of_different_sign(0.6);
  const PeriodicOrbit orbit =
      find_periodic_orbit(scene, at_quiet_phase(scene, settled(scene, 200)));
  ASSERT_TRUE(orbit.converged);
  const std::vector<Parameter> by{
      {Kind::omega, 0}, {Kind::beta, 0},        {Kind::restitution, 0}, {Kind::stop, 1},
      {Kind::stop, 2},  {Kind::restitution, 1}, {Kind::restitution, 2}, {Kind::amplitude, 2}};
  const OrbitChange change = orbit_change(scene, orbit, by);
  int compared = 0;
  for (std::size_t stop = 0; stop < 2; ++stop) {
    std::size_t impact = 0;
    for (const EventChange &at : change.events) {
      if (at.event.stop != stop) continue;
      for (std::size_t k = 0; k < by.size(); ++k) {
        const ImpactFamily family{scene, by[k], stop, 1};
        const ImpactOrbit found = impact_orbit_of(family, orbit, impact);
        EXPECT_TRUE(found.real);
        EXPECT_NEAR(found.parameter, get(scene, by[k]), 1e-11);
        const double slope =
            std::abs(at.event.velocity_before) / at.event.velocity_before * at.velocity_before[k];
        EXPECT_NEAR(found.parameter_by_speed * slope, 1.0, 1e-9) << name(by[k]);
        for (std::size_t i = 0; i < 4; ++i)
          EXPECT_NEAR(std::abs(found.multipliers[i] - orbit.multipliers[i]) *
                          std::abs(found.multipliers[i] - std::conj(orbit.multipliers[i])),
                      0.0, 1e-9);
        ++compared;
      }
      ++impact;
    }
    EXPECT_GE(impact, 2u) << stop;
  }
  EXPECT_GT(compared, 40);
}

// A family followed to another frequency is the orbit that Newton's method on the map finds there.
TEST(ImpactFamily, FollowedInOmegaStaysOnTheOrbits) {
  const Scene scene = paper::stops_of_different_sign(0.6);
  const PeriodicOrbit orbit =
      find_periodic_orbit(scene, at_quiet_phase(scene, settled(scene, 200)));
  const ImpactFamily family{scene, {Kind::omega, 0}, 1, 1};
  const ImpactOrbit start = impact_orbit_of(family, orbit);
  const auto followed = follow(family, start, start.speed + 2e-3, 5e-4);
  ASSERT_EQ(followed.back().speed, start.speed + 2e-3);
  const Scene there = with(scene, family.parameter, followed.back().parameter);
  EXPECT_GT(std::abs(there.omega - scene.omega), 1e-5);
  const MotionState seed = at_quiet_phase(there, followed.back().state);
  const PeriodicOrbit found = find_periodic_orbit(there, seed);
  ASSERT_TRUE(found.converged);
  EXPECT_LT(found.residuals.front(), 1e-11);  // it is that orbit already, to rounding
}

TEST(ImpactFamily, RefusesWhatIsNoFamily) {
  const VividRow &row = vivid_row("PD 1");
  const ImpactOrbit orbit = vivid_orbit(row);
  ImpactFamily family = vivid_family(row.omega, row.amplitude);
  const auto refused = [&] {
    EXPECT_THROW(impact_orbit(family, orbit, 0.1), std::invalid_argument);
    family = vivid_family(row.omega, row.amplitude);
  };
  family.stop = 1;
  refused();
  family.periods = 0;
  refused();
  family.parameter = {Kind::velocity, 1};
  refused();
  family.parameter = {Kind::stop, 2};
  refused();
  EXPECT_THROW(follow(family, orbit, 0.1, 0.0), std::invalid_argument);
  EXPECT_THROW(impact_orbit_of(family, PeriodicOrbit{}), std::invalid_argument);
  // An orbit ten times as fast under the same forcing would need r > 1.
  family.parameter = {Kind::restitution, 0};
  ImpactOrbit by_r = orbit;
  by_r.parameter = 0.9;
  by_r.by_speed.clear();
  EXPECT_TRUE(impact_orbit(family, by_r, row.speed).has_value());
  EXPECT_FALSE(impact_orbit(family, by_r, 10.0 * row.speed).has_value());
}

}  // namespace
