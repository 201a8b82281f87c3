// The special points and ends of branches, each with its value from a closed form, from the table
// of checked numbers, or from an integration by another program. Each was named wrongly, located to
// fewer digits or passed over by a search in the states at a section.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "tests/support/special_points.hpp"
#include "vibro_impact/analysis/analysis.hpp"
#include "vibro_impact/scene_text.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace {

using namespace vibro_impact;
using namespace vibro_impact::testing;
using Point = BranchPoint;

const std::string paper = "masses=2; amplitude=0.5,0; stop=1:lower:-0.3,2:upper:0.1; omega=";

// A symmetric or one-sided oscillator grazes where the amplitude of the steady motion is that of
// the stop: |1 - Omega^2 + i beta Omega| = A / s.
TEST(BranchEnds, GrazeOfOneMassIsFoundFromTheSideOfTheImpact) {
  expect_special_points("masses=1; amplitude=0.1; stop=1:upper:0.3; omega=1.1",
                        {"omega", 0.7, 1.6, 41},
                        {{Point::graze, 0.822788525650785},
                         {Point::flip, 0.974743623299196, 1e-12},
                         {Point::fold, 1.401586706382694, 1e-12},
                         {Point::graze, 1.145870429873033}});
  expect_special_points(
      "masses=1; amplitude=1; stop=1:upper:1; restitution=0.8; omega=1",
      {"amplitude1", 0.05, 1.2, 41},
      {{Point::graze, 0.1}, {Point::fold, 0.0999707536283133}, {Point::end_of_range, 1.2}});
  for (int k = 8; k <= 22; k += 2)
    for (const double r : {0.5, 0.8}) {
      Scene scene = scene_of("masses=1; amplitude=1; stop=1:upper:1");
      scene.omega = 0.1 * k;
      scene.restitution = r;
      const double graze = std::hypot(1.0 - scene.omega * scene.omega, 0.1 * scene.omega);
      scene.amplitude = {1.3 * graze};
      const auto branch = branch_of(scene, {"amplitude1", 0.01, 2.0 * graze, 41}, 1);
      const auto is_graze = [](const OrbitPoint &point) { return point.kind == Point::graze; };
      const auto found = std::ranges::find_if(branch, is_graze);
      if (found == branch.end()) continue;  // the orbit does not shrink into this graze
      EXPECT_NEAR(found->parameter, graze, 1e-13 * graze) << scene.omega << " " << r;
      EXPECT_EQ(std::ranges::count(branch, Point::lost, &OrbitPoint::kind), 0);
    }
}

TEST(BranchEnds, OrbitsOfThePaper) {
  expect_special_points(paper + "0.6", {"omega", 0.5, 0.7, 41},
                        {{Point::graze, 0.5830038349271824, 1e-14},
                         {Point::fold, 0.578747472191878, 1e-14},
                         {Point::graze, 0.60472477611858, 1e-13}});
  expect_special_points(
      paper + "0.35", {"omega", 0.32, 0.37, 30},
      {{Point::border_orbit, 0.330982352875060877}, {Point::border_orbit, 0.367004913968366919}});
  expect_special_points(
      paper + "0.256", {"omega", 0.25, 0.257, 11},
      {{Point::end_of_range, 0.25}, {Point::multi_sliding, 0.256006329803442272}});
  expect_special_points(
      paper + "0.2561", {"omega", 0.2555, 0.257, 11},
      {{Point::multi_sliding, 0.256006329803442272}, {Point::end_of_range, 0.257}});
}

// Masses 2 and 1 hit within 4e-11 at 0.03381. The orbit goes on with the order exchanged, and a
// multiplier jumps there from 66.55 to 51.95.
TEST(BranchEnds, EventsOfTwoMassesAtOneInstantEndNoBranch) {
  const auto branch = branch_of(scene_of(paper + "0.9"), {"stop2", 0.02, 0.4, 41});
  EXPECT_EQ(branch.front().kind, Point::end_of_range);
  EXPECT_EQ(branch.front().parameter, 0.02);
  const auto place = std::ranges::find(branch, Point::coincidence, &OrbitPoint::kind);
  ASSERT_NE(place, branch.end());
  EXPECT_NEAR(place->parameter, 0.0338106649, 1e-10);
}

TEST(BranchEnds, ABorderOrbitOrMultiSlidingHasItsNameFromBothSides) {
  expect_special_points("masses=1; amplitude=0.5; stop=1:upper:0.05; restitution=0; omega=2",
                        {"omega", 0.3, 3, 41},
                        {{Point::border_orbit, 1.82063209920272, 1e-13},
                         {Point::flip, 2.4626249619016, 1e-12},
                         {Point::end_of_range, 3}});
  expect_special_points(
      "masses=4; mass=2,2,0.211711,0.5; amplitude=0.2,-0.233058,0,0.5; restitution=0.3; "
      "stop=2:upper:0.430062,1:lower:-0.1,3:upper:0.1; omega=0.427811",
      {"omega", 0.306, 0.546, 41},
      {{Point::multi_sliding, 0.4132153748360035},
       {Point::border_orbit, 0.432820952540498, 1e-13}});
  expect_special_points(paper + "0.2", {"restitution", 0, 0.7, 8},
                        {{Point::end_of_range, 0}, {Point::end_of_range, 0.7}});
  // The border orbit of omega = 0.330982352875060877 lies at a parameter of 0.
  expect_special_points(
      paper + "0.330982352875060877; constant=0,-0.003", {"constant2", -0.01, 0.01, 21},
      {{Point::border_orbit, -0.0094124460563004, 1e-13}, {Point::border_orbit, 0.0, 1e-13}}, 0,
      2000);
  // Newton's method comes to r = -1e-34, which is no coefficient of restitution.
  expect_special_points(
      "masses=2; beta=0.2; amplitude=0,0.8502; sine=0.4803,-0.1572; restitution=0.3; "
      "stop=2:lower:-0.4104,1:upper:0.3709; omega=0.566811",
      {"restitution", 0, 0.6, 31},
      {{Point::end_of_range, 0}, {Point::border_orbit, 0.443218619173739, 1e-13}});
  // It comes to r = -1e-32 at the first orbit.
  expect_special_points(
      "masses=3; stiffness=2,0.70684,0.5; amplitude=1,1,-0.8183; restitution=0; "
      "stop=1:upper:0.2895,1:lower:-0.2245; omega=0.194378",
      {"restitution", 0, 0.3, 31}, {{Point::end_of_range, 0}, {Point::end_of_range, 0.3}}, 0, 600);
}

// A late impact of a chatter that changes places with an event of another mass may move the orbit
// by little. The branch ends there, for any number of values.
TEST(BranchEnds, ASmallJumpEndsABranch) {
  expect_special_points(
      "masses=4; stiffness=0.5,2,0.5,0.28784; beta=0.2; amplitude=0,0.2,0.2,0.7506; "
      "restitution=0.5; stop=1:lower:-0.0606,2:lower:-0.4737; omega=0.325372",
      {"omega", 0.2602976, 0.406715, 41},
      {{Point::end_of_range, 0.2602976}, {Point::jump, 0.36443672, 1e-8}}, 0, 600);
}

// Far from its limit, a chatter of few impacts has a force that grows during a flight.
TEST(BranchEnds, AChatterGrowsFromOneImpactWithTheRestitution) {
  expect_special_points(
      "masses=3; stiffness=0.5,3.10092,0.5; beta=0.05; amplitude=1,0.5,0.2; restitution=0; "
      "stop=2:upper:0.2824,2:lower:-0.0597,1:lower:-0.0825; omega=0.748412",
      {"restitution", 0, 0.3, 31}, {{Point::end_of_range, 0}, {Point::graze, 0.02168206514, 1e-11}},
      0, 600);
}

// A grazing between a release and the chatter after it.
TEST(BranchEnds, APhaseThatSplitsWithinAChatterIsSeen) {
  expect_special_points(
      "masses=2; beta=0.05; amplitude=0,0.882693; sine=0.376521,0.184679; "
      "constant=-0.040996,0.18265; restitution=0.8; stop=1:lower:-0.1; omega=0.141902",
      {"omega", 0.11281329074394154, 0.17289624803432249, 21},
      {{Point::end_of_range, 0.11281329074394154},
       {Point::multi_sliding, 0.155592610865196, 1e-13}});
}

// The end does not depend on the number of values, on the order of the stops or on the unit of
// mass.
TEST(BranchEnds, AnEndDoesNotDependOnTheWayToIt) {
  const std::string chain = "masses=2; mass=0.5,1.31561; amplitude=1,0.2; restitution=0.3; ";
  for (const char *stops : {"stop=1:lower:-0.156287,1:upper:0.156287; omega=2.32605",
                            "stop=1:upper:0.156287,1:lower:-0.156287; omega=2.32605"})
    for (const double unit : {1.0, 3.0})
      for (const std::size_t count : {33u, 50u, 65u}) {
        Scene scene = scene_of(chain + stops);
        for (auto *list : {&scene.mass, &scene.stiffness, &scene.amplitude})
          for (double &value : *list) value *= unit;
        const auto up = special_points_of(branch_of(scene, {"omega", 1.86084, 2.79126, count}));
        EXPECT_STREQ(name(up.back().kind), "graze");
        EXPECT_NEAR(up.back().parameter, 2.36315443268974, 1e-13) << stops << unit << count;
      }
}

// A branch does not turn back to where it came from, and keeps to its own orbits: the multipliers
// of a ball on a table are free of omega. The ball starts at its orbit of period 3. From
// displacement 1 its motion is irregular at first, and comes to the orbit of period 3 or of 13: a
// start at 1 + 1e-15 decides it.
TEST(BranchEnds, TheFirstStepKeepsToTheBranch) {
  const Scene ball = scene_of(
      "masses=1; stiffness=0; beta=0; constant=-1; amplitude=2.36807; omega=1; restitution=0.5; "
      "displacement=1.5992958181315975; velocity=1.7785897338959729; stop=1:lower:0");
  for (const std::size_t count : {11u, 41u}) {
    const auto branch = branch_of(ball, {"omega", 0.6, 1.4, count});
    EXPECT_EQ(branch.front().parameter, 0.6);
    EXPECT_EQ(branch.back().parameter, 1.4);
    for (const OrbitPoint &point : branch) {
      EXPECT_NEAR(point.orbit.multipliers[0].real(), -0.49886014, 1e-8) << point.parameter;
    }
  }
  expect_special_points(
      "masses=3; stiffness=1.9552,2,3.06437; beta=2; amplitude=0,1,0; restitution=0.6; "
      "stop=3:lower:-0.247964:0.3,3:upper:0.1; omega=2.04476",
      {"omega", 1.9, 2.2, 31},
      {{Point::end_of_range, 1.9},
       {Point::flip, 2.05864501943137, 1e-12},
       {Point::graze, 2.06164000255429, 1e-13}});
}

// A branch that turns round at its symmetric orbit goes on as its mirror image, one that turns
// round at the flip of its half as itself, and a closed one from its first orbit on.
TEST(BranchEnds, ABranchIsFollowedOnce) {
  expect_special_points(
      "masses=1; amplitude=1; stop=1:lower:-0.3,1:upper:0.3; omega=2", {"omega", 0.5, 3.5, 41},
      {{Point::graze, 1.679274514727752}, {Point::branching, 2.0277126613523457, 1e-12}});
  expect_special_points(
      "masses=1; amplitude=2; stop=1:lower:-0.5,1:upper:0.5; restitution=0.8; omega=2",
      {"amplitude1", 0.5, 3, 101},
      {{Point::branching, 1.5664910373758, 1e-11}, {Point::graze, 2.58668182039524, 1e-13}});
  expect_special_points("masses=1; beta=0.2; amplitude=0.5; stop=1:upper:0.05:0.8; omega=2.48806",
                        {"omega", 2.0547516450476704, 3.1611459995831126, 41},
                        {{Point::parent_flip, 2.45656107096918, 1e-13},
                         {Point::flip, 2.494412341424989, 1e-12},
                         {Point::flip, 2.711799053731982, 1e-12},
                         {Point::fold, 2.720071599399333, 1e-13},
                         {Point::graze, 2.672460125324297, 1e-13}});
  const auto closed = special_points_of(
      branch_of(scene_of("masses=2; stiffness=0.491739,0.5; amplitude=0.2,1; restitution=0.9; "
                         "stop=2:upper:0.1,2:lower:-0.2; omega=1.25173"),
                {"omega", 1.1, 1.56, 41}, 2));
  ASSERT_EQ(closed.size(), 3u);
  EXPECT_NEAR(closed[0].parameter, 1.268951144775291, 1e-14);
  EXPECT_NEAR(closed[1].parameter, 1.142293104064014, 1e-14);
  EXPECT_EQ(closed[2].kind, Point::closed);
}

// The unit of length grows with the orbits: a linear motion from a small amplitude reaches its
// graze in a bounded number of steps.
TEST(BranchEnds, ASmallMotionGrowsUpToItsGraze) {
  expect_special_points("masses=1; amplitude=0.01; stop=1:upper:1; restitution=0.8; omega=0.8",
                        {"amplitude1", 0.001, 0.5, 51},
                        {{Point::end_of_range, 0.001}, {Point::graze, 0.368781778291715}});
}

// Found by random branches: two flips or births of a torus within one step, and a torus next to a
// graze, where multipliers grow without bound.
TEST(BranchEnds, TwoSpecialPointsInOneStepAreBothSeen) {
  expect_special_points(
      "masses=2; beta=0.02; amplitude=0.2,0.2; restitution=0.3; "
      "stop=1:lower:-0.2101,1:upper:0.2006; omega=0.153959",
      {"omega", 0.1231672, 0.19244875, 41},
      {{Point::multi_sliding, 0.1269398541646231, 1e-13},
       {Point::torus, 0.1355039989387404, 1e-12},
       {Point::torus, 0.1361202649816639, 1e-12},
       {Point::flip, 0.1364765561528721, 1e-12},
       {Point::flip, 0.13705234297938, 1e-12},
       {Point::multi_sliding, 0.165398943382893, 1e-13}},
      0, 600);
  expect_special_points(
      "masses=3; stiffness=0.5,2,2; beta=0.2; amplitude=0.791,-0.4497,0.2; restitution=0.3; "
      "stop=1:upper:0.0835,2:lower:-0.2602; omega=0.874803",
      {"stop1", 0.04175, 0.12525, 31},
      {{Point::graze, 0.068372687779934, 1e-13},
       {Point::torus, 0.0870147333521998, 1e-12},
       {Point::graze, 0.087267408760897, 1e-13}},
      0, 600);
}

// A long step from one branch of orbits to another with the same events is refused.
TEST(BranchEnds, AStepKeepsToItsArc) {
  expect_special_points(
      "masses=1; stiffness=0.5; amplitude=1; restitution=0.8; "
      "stop=1:upper:0.378,1:lower:-0.3198; omega=1.45546",
      {"stop1", 0.189, 0.567, 31},
      {{Point::end_of_range, 0.189},
       {Point::flip, 0.3768451288666817, 1e-12},
       {Point::parent_flip, 0.3839432493130274, 1e-12}},
      0, 600);
  // A step beyond the flip of the parent would go on along the parent, whose periods are half.
  for (const std::size_t count : {31u, 41u, 81u})
    expect_special_points(
        "masses=2; stiffness=1.95996,2; beta=0.02; amplitude=0,0.5; restitution=0.7; "
        "stop=1:upper:0.1734; omega=1.26753",
        {"omega", 1.0140224, 1.58441, count},
        {{Point::parent_flip, 1.2665467605742, 1e-12},
         {Point::parent_flip, 1.280430526804639, 1e-12}},
        0, 600);
}

}  // namespace
