// Chains with one link so stiff and damped that it does not stretch: the motion does not depend on
// its stiffness. Between 1e14 and 1e18 it changes by some multiples of 1e-14, relative to the
// forces. At 1e18 the hold force of a mass beside the link counts as zero below 1e-9, within which
// the mass may leave its stop and come back. The tolerance of 1e-8 leaves room for the sensitivity
// of masses that bounce some twenty times.
#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "tests/support/random_scenes.hpp"
#include "vibro_impact/analysis/totals.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace {

using namespace vibro_impact;
using namespace vibro_impact::testing;

std::vector<StopTotals> totals(const Scene &scene, double to) {
  TotalsRecorder recorder(scene, 0.0, to);
  require_complete(simulate(scene, to, recorder));
  return recorder.stops;
}

void expect_independent_of_stiffness(Scene scene, std::size_t link, double to) {
  scene.stiffness[link] = 1e14;
  const std::vector<StopTotals> expected = totals(scene, to);
  for (const double stiffness : {1e15, 1e17, 1e18}) {
    scene.stiffness[link] = stiffness;
    const std::vector<StopTotals> found = totals(scene, to);
    for (std::size_t k = 0; k < found.size(); ++k) {
      EXPECT_NEAR(found[k].taken.impulse, expected[k].taken.impulse, 1e-8) << stiffness;
      EXPECT_NEAR(found[k].contact, expected[k].contact, 1e-8) << stiffness;
      EXPECT_NEAR(found[k].pressing, expected[k].pressing, 1e-8) << stiffness;
    }
  }
}

// A mass at the end of the link is released where its hold force vanishes, and hits again. The
// forces that decide its release lie below the rounding of those of the link.
TEST(StiffLinks, LetAReleasedMassHitAgain) {
  const Scene scene{.mass = {1.0, 1.0, 1.0},
                    .stiffness = {1.0, 1.0, 1.0},
                    .beta = 0.1,
                    .amplitude = {0.5, 0.5, 0.5},
                    .omega = 0.256,
                    .restitution = 0.7,
                    .stops = {{3, Side::upper, 0.1}}};
  expect_independent_of_stiffness(scene, 2, 50.0);
}

TEST(StiffLinks, DoNotStretchInRandomScenes) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(seed);
    Draw draw{std::mt19937(seed)};
    Scene scene;
    const int masses = draw.between(2, 4);
    for (int i = 0; i < masses; ++i) {
      scene.mass.push_back(1.0);
      scene.stiffness.push_back(draw.one_of({0.5, 1.0, 2.0}));
      scene.amplitude.push_back(draw.one_of({-0.5, 0.0, 0.5, 1.0}));
    }
    scene.beta = draw.one_of({0.02, 0.05, 0.1, 0.5});
    scene.omega = draw.uniform(0.2, 1.5);
    scene.restitution = draw.one_of({0.3, 0.5, 0.7});
    scene.stops = {{draw.between(1, masses), Side::upper, draw.uniform(0.02, 0.5)}};
    if (draw.one_in(2))
      scene.stops.push_back({draw.between(1, masses), Side::lower, -draw.uniform(0.02, 0.5)});
    expect_independent_of_stiffness(scene, draw.below(static_cast<unsigned>(masses)), 20.0);
  }
}

}  // namespace
