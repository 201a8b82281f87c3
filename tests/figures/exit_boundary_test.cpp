// The exit boundaries of Section 3.2, on which every release at a root of the hold force lies.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "reference/scenes/paper_scenes.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace {

using namespace vibro_impact;

// Where the other mass is when a mass is let go at a root of its hold force.
struct ReleaseRecorder {
  int mass = 1;
  std::vector<std::array<double, 2>> others = {};  // displacement and velocity
  std::vector<double> phases = {};                 // time within the forcing period
  void event(const Event &event, const Moment &moment) {
    if (event.kind != EventKind::release || event.mass != mass || event.by_a_jump) return;
    others.push_back({moment.displacement(3 - mass), moment.velocity(3 - mass)});
    phases.push_back(event.instant.phase);
  }
};

// A release is the root of F, whose terms are of order 1 and carry rounding of some 1e-15; divided
// by c = 0.1 that is 1e-14 in the velocity, with room for the summation 1e-13.
constexpr double on_boundary = 1e-13;

TEST(ExitBoundary, OfMassTwoIsTheLineOfEquation23) {
  // The boundary does not depend on the forcing: transients at several frequencies and amplitudes
  // spread the points along it.
  ReleaseRecorder releases{2};
  for (double amplitude : {0.3, 0.5, 0.9, 1.5})
    for (double omega : {0.25, 0.28, 0.31, 0.34, 0.36, 0.41, 0.45}) {
      Scene scene = paper::figure3(omega);
      scene.amplitude[0] = amplitude;
      require_complete(simulate(scene, 20.0 * Clock(omega).period, {}, releases));
    }
  ASSERT_GT(releases.others.size(), 100u);
  const auto [left, right] = std::minmax_element(releases.others.begin(), releases.others.end());
  EXPECT_GT((*right)[0] - (*left)[0], 0.05);
  // Printed, and derived: slope -k / c and intercept k s2 / c.
  for (const auto &[x1, v1] : releases.others) EXPECT_NEAR(v1, -10.0 * x1 + 1.0, on_boundary);
}

TEST(ExitBoundary, OfMassOneMovesWithTheForcing) {
  ReleaseRecorder releases{1};
  const Scene scene = paper::figure2();
  require_complete(simulate(scene, 750.0, {}, releases));
  ASSERT_GT(releases.others.size(), 30u);
  for (std::size_t i = 0; i < releases.others.size(); ++i) {
    const auto &[x2, v2] = releases.others[i];
    // Equation 20 set to zero, s1 = -0.3.
    EXPECT_NEAR(v2, -10.0 * (x2 + 0.6) - 5.0 * std::cos(scene.omega * releases.phases[i]),
                on_boundary);
  }
}

}  // namespace
