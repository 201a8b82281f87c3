// Branches of random scenes. Their ends are the same for another number of values, another order of
// the stops and their mirror images. Their orbits are orbits of the simulation: the motion from
// the state of a point returns to it with the same events.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <vector>

#include "tests/support/random_scenes.hpp"
#include "tests/support/special_points.hpp"
#include "vibro_impact/analysis/analysis.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace {

using namespace vibro_impact;
using namespace vibro_impact::testing;

struct RandomBranch {
  Scene scene;
  Axis range;
};

// One to four masses with one to three stops, and a parameter of five kinds. Two masses often hit
// at one instant along such a branch, and many chatter.
RandomBranch random_branch(unsigned seed) {
  std::mt19937 random(seed);
  const auto pick = [&random](std::vector<double> values) {
    return values[random() % values.size()];
  };
  const auto between = [&random](double from, double to) {
    return from + (to - from) * (static_cast<double>(random()) / 4294967296.0);
  };
  const auto n = static_cast<std::size_t>(pick({1, 1, 2, 2, 2, 3, 4}));
  RandomBranch result;
  Scene &scene = result.scene;
  for (std::size_t i = 0; i < n; ++i) {
    scene.mass.push_back(pick({1.0, 0.5, 2.0, between(0.2, 3.0)}));
    scene.stiffness.push_back(pick({1.0, 0.5, 2.0, between(0.2, 4.0)}));
    scene.amplitude.push_back(pick({0.0, 0.2, 0.5, 1.0, between(-1.0, 1.0)}));
  }
  scene.beta = pick({0.02, 0.05, 0.1, 0.2, 0.5});
  scene.omega = between(0.15, 2.5);
  scene.restitution = pick({0.0, 0.3, 0.5, 0.6, 0.7, 0.8, 0.9});
  for (int k = static_cast<int>(pick({1, 1, 2, 2, 3})); k > 0; --k) {
    const int mass = 1 + static_cast<int>(random() % n);
    const Side side = random() % 2 == 0 ? Side::lower : Side::upper;
    const bool taken = std::ranges::any_of(
        scene.stops, [&](const Stop &stop) { return stop.mass == mass && stop.side == side; });
    if (!taken) scene.stops.push_back({mass, side, sign(side) * between(0.02, 0.5)});
  }
  const double w = scene.omega, r = scene.restitution, a = scene.amplitude[0], b = scene.beta,
               s = scene.stops[0].position;
  const std::vector<Axis> ranges{
      {"omega", 0.8 * w, 1.25 * w, 41},
      {"omega", 0.8 * w, 1.25 * w, 41},
      {"amplitude1", a - 0.2, a + 0.2, 41},
      {"restitution", std::max(0.0, r - 0.3), std::min(0.98, r + 0.3), 31},
      {"beta", 0.5 * b, 1.5 * b, 31},
      {"stop1", 0.5 * s, 1.5 * s, 31}};
  result.range = ranges[random() % ranges.size()];
  return result;
}

// The settled orbit of the scene, if there is one.
std::optional<OrbitPoint> settled_orbit(const Scene &scene) {
  const OrbitRecord settled = record_of(scene, {.settle = {.longest = 600}});
  if (settled.period == 0) return {};
  const OrbitPoint found = find_orbit(scene, at_quiet_phase(scene, settled.state), settled.period);
  if (!found.orbit.converged) return {};
  return found;
}

std::vector<OrbitPoint> branch_of(const RandomBranch &of, const OrbitPoint &from,
                                  std::size_t count) {
  Axis range = of.range;
  range.count = count;
  return follow_orbit(of.scene, from.orbit.state, range, {.periods = from.counts.periods});
}

// Special points agree to their errors and to the rounding of the map, which ill-conditioned
// branches multiply: some 1e-13 in these scenes.
void expect_same(const std::vector<OrbitPoint> &a, const std::vector<OrbitPoint> &b) {
  const auto x = special_points_of(a), y = special_points_of(b);
  ASSERT_EQ(x.size(), y.size());
  for (std::size_t k = 0; k < x.size(); ++k) {
    EXPECT_STREQ(name(x[k].kind), name(y[k].kind));
    if (x[k].kind == BranchPoint::closed) continue;  // at any of its orbits
    EXPECT_NEAR(x[k].parameter, y[k].parameter, 3.0 * (x[k].error + y[k].error) + 1e-12);
  }
}

// The distance of the return after the periods of the orbit grows with its multipliers.
void expect_orbit_of_the_simulation(const RandomBranch &of, const OrbitPoint &point) {
  if (point.kind != BranchPoint::orbit) return;  // at the others two events may coincide
  Scene scene = with(of.scene, of.range.parameter, point.parameter);
  scene.displacement = point.orbit.state.displacement;
  const MotionState end = stroboscopic_map(scene, point.orbit.state, point.counts.periods);
  double size = 1e-3, apart = 0.0, largest = 1.0;
  for (std::size_t i = 0; i < scene.mass.size(); ++i) {
    const double x = point.orbit.state.displacement[i], v = point.orbit.state.velocity[i];
    size = std::max({size, std::abs(x), std::abs(v)});
    apart = std::max({apart, std::abs(end.displacement[i] - x), std::abs(end.velocity[i] - v)});
  }
  for (const auto &multiplier : point.orbit.multipliers)
    largest = std::max(largest, std::abs(multiplier));
  EXPECT_LT(apart, 1e-11 * largest * size) << of.range.parameter << " " << point.parameter;
  EXPECT_EQ(end.held, point.orbit.state.held);
}

TEST(RandomBranches, HaveEndsThatDependOnNothingElse) {
  int branches = 0, ends = 0;
  for (unsigned seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(seed);
    const RandomBranch of = random_branch(seed);
    const auto from = settled_orbit(of.scene);
    if (!from) continue;
    ++branches;
    const auto branch = branch_of(of, *from, of.range.count);
    EXPECT_NE(branch.back().kind, BranchPoint::lost) << branch.back().orbit.why_not;
    ends += static_cast<int>(special_points_of(branch).size());
    expect_same(branch, branch_of(of, *from, 2 * of.range.count - 1));
    for (std::size_t k = 0; k < branch.size(); k += 7)
      expect_orbit_of_the_simulation(of, branch[k]);
    if (of.range.parameter.starts_with("stop")) continue;  // numbers of stops change
    RandomBranch other = of;
    std::ranges::reverse(other.scene.stops);
    expect_same(branch, branch_of(other, *from, of.range.count));
    if (of.range.parameter.starts_with("amplitude")) continue;  // an amplitude changes its sign
    const RandomBranch mirror{mirrored(of.scene), of.range};
    if (const auto image = settled_orbit(mirror.scene))
      expect_same(branch, branch_of(mirror, *image, of.range.count));
  }
  EXPECT_GT(branches, 20);
  EXPECT_GT(ends, branches);
}

// The ends of a branch are those of a branch from its other end: the orbit in its middle leads back
// to where it came from.
TEST(RandomBranches, LeadBackToTheirFirstOrbit) {
  for (unsigned seed = 100; seed < 120; ++seed) {
    SCOPED_TRACE(seed);
    const RandomBranch of = random_branch(seed);
    const auto from = settled_orbit(of.scene);
    if (!from) continue;
    const auto branch = branch_of(of, *from, of.range.count);
    const OrbitPoint &middle = branch[branch.size() / 2];
    const bool single_valued = std::ranges::none_of(branch, [](const OrbitPoint &point) {
      return point.kind == BranchPoint::fold || point.kind == BranchPoint::branching;
    });
    if (middle.kind != BranchPoint::orbit || !single_valued) continue;
    RandomBranch back = of;
    back.scene = with(of.scene, of.range.parameter, middle.parameter);
    back.scene.displacement = middle.orbit.state.displacement;
    const auto forth = branch_of(back, middle, of.range.count);
    EXPECT_STREQ(name(forth.back().kind), name(branch.back().kind));
    EXPECT_NEAR(forth.back().parameter, branch.back().parameter, 1e-12);
  }
}

}  // namespace
