// Period doublings and folds as curves of two parameters, and where they end: against published
// curves of a single oscillator, closed forms, and the Floquet multipliers of the stroboscopic map.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "figures/beyond/curves.hpp"
#include "tests/reference/published_vivid.hpp"

namespace {

using namespace vibro_impact;
using namespace vibro_impact::figures;

constexpr PlaneBox box{0.0, 0.6, 0.75, 1.05};  // F and omega

BifurcationCurve curve_of(const VividRow &row) {
  const bool doubling = row.multiplier < 0.0;
  return {doubling ? Bifurcation::period_doubling : Bifurcation::fold,
          vivid_oscillator(row.omega, row.amplitude),
          parameter_named("amplitude1"),
          parameter_named("omega"),
          0,
          2};
}

FollowedCurve followed(const BifurcationCurve &curve, const VividRow &start, int direction) {
  const auto point = point_of(curve, vivid_orbit(start));
  EXPECT_TRUE(point) << start.name;
  if (!point) return {};
  return follow_curve(corrector_of(curve), *point, box, direction,
                      {.step = 0.02, .least_step = 1e-7, .most = 400}, end_conditions(curve));
}

// A curve started at the first row of a branch goes through all the others. The rows are off the
// bifurcation by up to 1e-5 in the multiplier; at their distance from it in the speed, which is at
// most 5e-5, the amplitude of a period doubling is off by 4e-6, of a fold by the square.
TEST(ImpactCurve, GoesThroughThePublishedRows) {
  for (const std::string branch : {"PD", "PDb", "SN", "SNb"}) {
    std::vector<VividRow> rows;
    for (const VividRow &row : published_vivid())
      if (row.name.starts_with(branch + " ")) rows.push_back(row);
    ASSERT_EQ(rows.size(), 12u) << branch;
    const BifurcationCurve curve = curve_of(rows.front());
    std::vector<CurvePoint> points;
    for (const int direction : {1, -1})
      for (const CurvePoint &point : followed(curve, rows.front(), direction).points)
        points.push_back(point);
    for (const VividRow &row : rows) {
      const auto apart = [&](const CurvePoint &point) {
        return std::hypot(point.at.x - row.amplitude, point.at.y - row.omega);
      };
      const CurvePoint nearest =
          *std::min_element(points.begin(), points.end(),
                            [&](const auto &a, const auto &b) { return apart(a) < apart(b); });
      const auto there = corrector_of(curve)({nearest.at.x, row.omega}, {1.0, 0.0}, nearest);
      ASSERT_TRUE(there) << row.name;
      EXPECT_NEAR(there->at.x, row.amplitude, branch[0] == 'P' ? 4e-6 : 1e-10) << row.name;
      EXPECT_NEAR(there->speed, row.speed, 5e-5) << row.name;
    }
  }
}

// Both end where the motion without impact grazes and the stretch of it that the impact sees is
// half a whole number of oscillations: at omega = 2 / 5 of twice the damped frequency, and the
// doubling, on its other side, at the damped frequency itself.
TEST(ImpactCurve, EndsOnTheGrazingCurveWhereTheFlightIsHalfAWholeNumberOfOscillations) {
  const double damped = std::sqrt(1.0 - 0.02 * 0.02);
  struct End {
    const char *row;
    int direction;
    double omega;
  };
  for (const End &due :
       {End{"PD 1", 1, 0.8 * damped}, End{"PD 1", -1, damped}, End{"SN 1", -1, 0.8 * damped}}) {
    const VividRow &row = vivid_row(due.row);
    const BifurcationCurve curve = curve_of(row);
    const FollowedCurve found = followed(curve, row, due.direction);
    ASSERT_EQ(found.end, CurveEnd::lost) << due.row;
    const auto end = end_of(corrector_of(curve), end_conditions(curve), found, box);
    ASSERT_TRUE(end) << due.row;
    EXPECT_EQ(end->condition, "grazing of mass 1") << due.row;
    EXPECT_NEAR(end->at.y, due.omega, 1e-9) << due.row;
    EXPECT_NEAR(end->at.x, std::hypot(1.0 - due.omega * due.omega, 0.04 * due.omega), 1e-9);
    EXPECT_LT(end->error, 1e-9) << due.row;
  }
}

// Two masses: ten points of each curve of the atlas, at random. The multiplier of the stroboscopic
// map there is -1 or 1 (1e-8: it grows to a hundred where an impact grazes), and the number of
// multipliers outside the unit circle changes on a doubling, to 1e-9 in units of the box.
TEST(ImpactCurve, OfTwoMassesHasTheMultipliersOfTheStroboscopicMap) {
  const PlaneBox plane = omega_r_plane().box;
  for (const FamilyStart &start : family_starts()) {
    const StartedCurve found = started(start);
    std::vector<CurvePoint> points;
    for (const int direction : {1, -1}) {
      const FollowedCurve curve = follow_curve(corrector_of(found.curve), found.point, plane,
                                               direction, {.step = 0.015, .least_step = 1e-4});
      EXPECT_GT(curve.points.size(), 5u) << start.name;
      points.insert(points.end(), curve.points.begin(), curve.points.end());
    }
    std::mt19937 random(15);
    const bool doubling = start.what == Bifurcation::period_doubling;
    for (int k = 0; k < 10; ++k) {
      const CurvePoint &point = points[random() % points.size()];
      EXPECT_NEAR(multiplier_at(found.curve, point, plane), doubling ? -1.0 : 1.0, 1e-8)
          << start.name << " " << point.at.x << " " << point.at.y;
      if (!doubling) continue;
      const auto distance = distance_by_counting(found.curve, point, plane);
      ASSERT_TRUE(distance) << start.name << " " << point.at.x << " " << point.at.y;
      EXPECT_LT(*distance, 1e-9) << start.name;
    }
  }
}

TEST(ImpactCurve, RefusesTheStartOfAnotherKind) {
  const VividRow &row = vivid_row("PD 1");
  BifurcationCurve curve = curve_of(row);
  const ImpactOrbit orbit = vivid_orbit(row);
  EXPECT_THROW(point_of(curve, {0.3475, 0.81}, {1.0, 0.0}, orbit.state, 0.0),
               std::invalid_argument);
  curve.what = Bifurcation::grazing;
  EXPECT_THROW(point_of(curve, orbit), std::invalid_argument);
}

}  // namespace
