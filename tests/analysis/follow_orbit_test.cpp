// Branches of periodic orbits: folds and flips of one mass in closed form, and the ends of the
// branches of Figure 3.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "reference/scenes/extreme_scenes.hpp"
#include "reference/scenes/paper_scenes.hpp"
#include "vibro_impact/analysis/analysis.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace {

using namespace vibro_impact;

// Orbits of one mass with one impact in two forcing periods: x'' + c x' + x = A cos(omega t) below
// the stop 1, with c = 0.04 and r = 0.9. (a11 a12; a21 a22) is the transition of the free motion
// over the period. With the impact speed y, alpha y is the free part of the displacement at the
// impact and (1 - beta) y the velocity of the steady part, so that A^2 = Z^2 ((1 - alpha y)^2 +
// (q y)^2), where q = (1 - beta) / omega and Z^2 = (1 - omega^2)^2 + (c omega)^2.
//
// A symmetric orbit between stops at 1 and -1 has an impact in half a forcing period, after which
// its mirror image is the same orbit. The transition of this image has the opposite sign, and so
// has no other change. Where the image flips, its map applied twice has the multiplier 1.
struct OneImpact {
  static constexpr double c = 0.04, r = 0.9;
  bool symmetric;
  double periods;  // between impacts
  double omega, z, alpha, q, trace_of_flow, a12, beta;

  explicit OneImpact(double frequency, bool between_stops = false)
      : symmetric(between_stops), periods(between_stops ? 0.5 : 2.0), omega(frequency) {
    const double t = periods * 2.0 * std::numbers::pi / omega, w = std::sqrt(1.0 - c * c / 4.0),
                 decay = (symmetric ? -1.0 : 1.0) * std::exp(-c * t / 2.0),
                 cosine = decay * std::cos(w * t);
    a12 = decay * std::sin(w * t) / w;
    const double a11 = cosine + c / 2.0 * a12, a22 = cosine - c / 2.0 * a12;
    trace_of_flow = a11 + a22;
    alpha = (1.0 + r) / (-a12 + (a22 - 1.0) * (1.0 - a11) / a12);
    beta = alpha * (1.0 - a11) / a12 + 1.0 + r;
    q = (1.0 - beta) / omega;
    z = std::hypot(1.0 - omega * omega, c * omega);
  }
  double amplitude(double y) const {
    return z * std::hypot(1.0 - alpha * y, q * y);
  }
  // The amplitude is stationary in the speed.
  double fold() const {
    return amplitude(alpha / (alpha * alpha + q * q));
  }
  // 1 + trace + determinant = 0 is linear in 1/y.
  double speed_at_flip() const {
    const double determinant = r * r * std::exp(-c * periods * 2.0 * std::numbers::pi / omega),
                 k = -(1.0 + determinant - r * trace_of_flow) / a12,
                 c0 = -(1.0 + r) * omega * omega,
                 c1 = (1.0 + r) * (c * (1.0 - beta) - (1.0 - omega * omega) * alpha);
    return c0 / (k - c1);
  }
  Scene scene(double y) const {
    Scene scene = extremes::one_mass(c, amplitude(y), omega, r, 1.0);
    if (symmetric) scene.stops.push_back({1, Side::lower, -1.0});
    return scene;
  }
  // The steady part is Re(A H e^(i omega t)), H = 1 / (1 - omega^2 + i c omega).
  MotionState after_impact(double y) const {
    const std::complex<double> steady(1.0 - alpha * y, -q * y),
        inverse(1.0 - omega * omega, c * omega);
    const double period = 2.0 * std::numbers::pi / omega,
                 time = (std::arg(steady) + std::arg(inverse)) / omega;
    return {{0, time - period * std::floor(time / period)}, {1.0}, {-r * y}, {0}};
  }
};

std::vector<OrbitPoint> branch_of(const OneImpact &known, double y, double from, double to,
                                  std::size_t count = 20) {
  const Scene scene = known.scene(y);
  const double a = scene.amplitude[0];
  return follow_orbit(scene, at_quiet_phase(scene, known.after_impact(y)),
                      {"amplitude1", from * a, to * a, count},
                      {.periods = known.symmetric ? 1 : 2});
}

// The branch of the orbit at which the motion from rest settles.
std::vector<OrbitPoint> settled_branch(const Scene &scene, const Axis &range, int most = 1000) {
  return follow_orbit(scene, at_quiet_phase(scene, record_of(scene).state), range,
                      {.most_points = most});
}

const OrbitPoint &point_of_kind(const std::vector<OrbitPoint> &branch, BranchPoint kind) {
  const auto found = std::ranges::find(branch, kind, &OrbitPoint::kind);
  if (found == branch.end()) throw std::runtime_error(std::string("no ") + name(kind));
  return *found;
}

// The fold is passed from the unstable branch, and the branch goes on in the other direction,
// stable. The amplitude is stationary at a fold, and so is known to rounding.
TEST(FollowOrbit, PassesTheFoldInClosedForm) {
  const OneImpact known(0.79);
  const std::vector<OrbitPoint> branch = branch_of(known, 0.3, 1.1, 0.9);
  const OrbitPoint &fold = point_of_kind(branch, BranchPoint::fold);
  EXPECT_NEAR(fold.parameter, known.fold(), 1e-13);
  EXPECT_FALSE(branch.front().orbit.stable());
  const auto after = std::ranges::find(branch, BranchPoint::fold, &OrbitPoint::kind) + 1;
  ASSERT_LT(after, branch.end());
  EXPECT_TRUE(after->orbit.stable());
  EXPECT_GT(after->parameter, fold.parameter);
  EXPECT_EQ(after->counts.impacts, std::vector{1});
}

// A multiplier passes -1, at a place that is as exact as the multipliers times the slope of the
// branch. The unstable orbits beyond it are followed to the grazing, at the amplitude Z.
TEST(FollowOrbit, PassesTheFlipInClosedFormAndEndsAtTheGrazing) {
  const OneImpact known(0.81);
  const std::vector<OrbitPoint> branch = branch_of(known, 0.3, 1.3, 0.7);
  EXPECT_TRUE(branch.front().orbit.stable());
  EXPECT_NEAR(point_of_kind(branch, BranchPoint::flip).parameter,
              known.amplitude(known.speed_at_flip()), 1e-12);
  EXPECT_EQ(branch.back().kind, BranchPoint::graze);
  EXPECT_FALSE(branch.back().orbit.stable());
  EXPECT_LT(branch.size(), 30u);
  EXPECT_NEAR(branch.back().parameter, known.z, 1e-14);
}

// Two asymmetric orbits, mirror images of each other, branch off where the symmetric orbit loses
// its stability. Newton's method is singular there. The point is interpolated from orbits around it
// to some 1e-12, at most 3e-13 in these.
TEST(FollowOrbit, PassesTheBranchingOfASymmetricOrbitInClosedForm) {
  for (const double omega : {1.05, 1.5, 2.0})
    for (const std::size_t count : {5u, 10u, 20u, 40u, 160u}) {
      SCOPED_TRACE(::testing::Message() << omega << " " << count);
      const OneImpact known(omega, true);
      const double y = known.speed_at_flip();
      const std::vector<OrbitPoint> branch = branch_of(known, 1.2 * y, 1.1, 0.7, count);
      EXPECT_EQ(branch.front().counts.impacts, std::vector{2});
      EXPECT_FALSE(branch.front().orbit.stable());
      EXPECT_TRUE(branch.back().orbit.stable());
      const OrbitPoint &point = point_of_kind(branch, BranchPoint::branching);
      EXPECT_NEAR(point.parameter, known.amplitude(y), 1e-11);
      EXPECT_LE(std::abs(point.parameter - known.amplitude(y)), point.error);
    }
}

// In Figure 3 the orbit of Figure 2 ends where a sticking phase of mass 2 splits (Figure 4(a)), at
// the frequency that the table of checked numbers has. Below, it goes to the end of the range. Both
// ranges begin at the scene.
TEST(FollowOrbit, EndsAtTheMultiSlidingAndAtTheEndOfItsRange) {
  const Scene scene = paper::figure2();
  const auto up = settled_branch(scene, {"omega", 0.2, 0.3, 27});
  EXPECT_EQ(up.back().kind, BranchPoint::multi_sliding);
  EXPECT_NEAR(up.back().parameter, 0.256006329803442272, 1e-15);
  const auto down = settled_branch(scene, {"omega", 0.2, 0.15, 14});
  EXPECT_EQ(down.back().kind, BranchPoint::end_of_range);
  EXPECT_EQ(down.back().parameter, 0.15);
}

// The start of the scene, at 0, is beyond stops that the branch moves across it.
TEST(FollowOrbit, GoesOnWhereAStopPassesTheStartOfTheScene) {
  EXPECT_EQ(settled_branch(paper::figure2(), {"stop1", -0.5, 0.05, 56}).back().kind,
            BranchPoint::end_of_range);
}

// With A_1 mass 1 begins to hit its stop once more between its release and its next chatter. At the
// other end of the branch it loses a sticking phase. Both are seen in the settled motion.
TEST(FollowOrbit, EndsWhereTheSettledMotionGainsAnImpactOrLosesASticking) {
  const Scene scene = paper::figure3(0.28);
  const auto events_at = [&](double amplitude) {
    return record_of(with(scene, "amplitude1", amplitude)).counts;
  };
  const auto up = settled_branch(scene, {"amplitude1", 0.1, 1.0, 101});
  EXPECT_EQ(up.back().kind, BranchPoint::graze);
  const double graze = up.back().parameter;
  EXPECT_NE(events_at(graze - 1e-7).impacts, events_at(graze + 1e-7).impacts);
  const auto down = settled_branch(scene, {"amplitude1", 1.0, 0.1, 101});
  EXPECT_EQ(down.back().kind, BranchPoint::border_orbit);
  const double end = down.back().parameter;
  EXPECT_NE(events_at(end - 1e-7).sticks, events_at(end + 1e-7).sticks);
}

// A parameter that an orbit does not depend on grows by equal steps, which end at the end of the
// range but for rounding.
TEST(FollowOrbit, TakesTheEndOfItsRangeOnce) {
  for (const std::size_t count : {4u, 5u, 8u, 11u}) {
    const Scene scene = extremes::one_mass(0.1, 0.1, 1.3, 0.7, 0.9);
    const auto branch = settled_branch(scene, {"stop1", 0.9, 0.5, count});
    EXPECT_EQ(branch.size(), count);
    EXPECT_EQ(branch.back().kind, BranchPoint::end_of_range);
  }
}

// The chatter of a mass becomes incomplete: its sticking phase shrinks to nothing. The table of
// checked numbers has these frequencies, found by counting phases and confirmed to 50 digits. The
// rounding of a double there is 6e-17.
TEST(FollowOrbit, EndsAtTheBorderOrbits) {
  const auto end_of = [](double from, double middle, double to) {
    return settled_branch(paper::figure3(middle), {"omega", from, to, 30}).back();
  };
  for (const auto &[end, expected] : {std::pair{end_of(0.32, 0.35, 0.37), 0.367004913968366919},
                                      {end_of(0.37, 0.35, 0.32), 0.330982352875060877},
                                      {end_of(0.44, 0.45, 0.5), 0.46421518719298115}}) {
    EXPECT_EQ(end.kind, BranchPoint::border_orbit);
    EXPECT_NEAR(end.parameter, expected, 4e-15);
  }
}

// Two complex multipliers leave the unit circle between a stable orbit and an unstable one. The
// modulus at the point is found again from the scene there, to the accuracy of Newton's method.
TEST(FollowOrbit, PassesTheBirthOfATorus) {
  Scene scene = paper::figure3(0.8);
  scene.beta = 0.02;
  scene.stops = {{2, Side::upper, 0.2}};
  const auto branch = settled_branch(scene, {"omega", 0.81, 0.78, 30});
  const auto torus = std::ranges::find(branch, BranchPoint::torus, &OrbitPoint::kind);
  ASSERT_TRUE(torus > branch.begin() && torus + 1 < branch.end());
  EXPECT_NE((torus - 1)->orbit.stable(), (torus + 1)->orbit.stable());
  scene.omega = torus->parameter;
  const PeriodicOrbit orbit = find_periodic_orbit(scene, torus->orbit.state);
  ASSERT_TRUE(orbit.converged);
  EXPECT_NE(orbit.multipliers[0].imag(), 0.0);
  EXPECT_NEAR(std::abs(orbit.multipliers[0]), 1.0, 1e-10);
}

// At 0.6 the orbit of Figure 3 is stable. Downwards it turns round at a fold.
TEST(FollowOrbit, GoesThroughUnstablePartsOfFigure3) {
  const Scene scene = paper::figure3(0.6);
  const auto branch = settled_branch(scene, {"omega", 0.7, 0.5, 100});
  const OrbitPoint &fold = point_of_kind(branch, BranchPoint::fold);
  EXPECT_NEAR(std::abs(fold.orbit.multipliers.front()), 1.0, 1e-6);
  EXPECT_FALSE(branch.back().orbit.stable());
  EXPECT_GT(branch.back().parameter, fold.parameter);
  EXPECT_EQ(branch.back().kind, BranchPoint::graze);
  const auto few = settled_branch(scene, {"omega", 0.7, 0.5, 100}, 5);
  EXPECT_EQ(few.size(), 5u);
  EXPECT_EQ(few.back().kind, BranchPoint::most_points);
}

}  // namespace
