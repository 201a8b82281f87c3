// Curves in the plane of two parameters: the continuation itself on a curve known in closed form,
// and the curves of multi-sliding and of border orbits against counts of sticking phases.
#include "vibro_impact/analysis/continuation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "figures/beyond/curves.hpp"
#include "reference/table_reader.hpp"

namespace {

using namespace vibro_impact;
using namespace vibro_impact::figures;

// The zero of x^2 / 4 + y^2 - 1 by Newton's method across the curve.
std::optional<CurvePoint> on_ellipse(const PlanePoint &guess, const PlanePoint &across,
                                     const CurvePoint &) {
  double s = 0.0;
  for (int step = 0; step < 20; ++step) {
    const double x = guess.x + s * across.x, y = guess.y + s * across.y;
    s -= (x * x / 4.0 + y * y - 1.0) / (x * across.x / 2.0 + 2.0 * y * across.y);
  }
  const PlanePoint at{guess.x + s * across.x, guess.y + s * across.y};
  if (!(std::abs(at.x * at.x / 4.0 + at.y * at.y - 1.0) < 1e-14)) return std::nullopt;
  return CurvePoint{at, {at.x / 2.0, 2.0 * at.y}, 1e-16, {}};
}

const CurvePoint on_axis{{2.0, 0.0}, {1.0, 0.0}, 0.0, {}};

TEST(FollowCurve, TurnsAndCloses) {
  for (int direction : {1, -1}) {
    const FollowedCurve curve =
        follow_curve(on_ellipse, on_axis, {-3.0, 3.0, -3.0, 3.0}, direction, {.step = 0.02});
    EXPECT_EQ(curve.end, CurveEnd::closed);
    double area = 0.0;
    for (std::size_t k = 0; k + 1 < curve.points.size(); ++k) {
      const PlanePoint &a = curve.points[k].at, &b = curve.points[k + 1].at;
      area += 0.5 * (a.x * b.y - a.y * b.x);
      EXPECT_LT(std::hypot(a.x - b.x, a.y - b.y), 1.5 * 0.02 * 6.0);
    }
    // Of the polygon: pi a b but for the square of the step; the gradient, outwards, is to the left
    // of a way in clockwise sense.
    EXPECT_NEAR(area, -direction * 2.0 * std::acos(-1.0), 0.05);
  }
}

TEST(FollowCurve, EndsOnTheSideOfTheBox) {
  const FollowedCurve curve =
      follow_curve(on_ellipse, on_axis, {-3.0, 3.0, -3.0, 0.5}, -1, {.step = 0.03});
  EXPECT_EQ(curve.end, CurveEnd::box);
  EXPECT_EQ(curve.points.back().at.y, 0.5);
  EXPECT_NEAR(curve.points.back().at.x, std::sqrt(3.0), 1e-14);
}

TEST(FollowCurve, IsGivenUpWhereTheCorrectorFindsNothing) {
  const Corrector half = [](const PlanePoint &guess, const PlanePoint &across,
                            const CurvePoint &near) {
    auto found = on_ellipse(guess, across, near);
    return found && found->at.x > 0.0 ? found : std::nullopt;
  };
  const FollowedCurve curve =
      follow_curve(half, on_axis, {-3.0, 3.0, -3.0, 3.0}, 1, {.least_step = 1e-9});
  EXPECT_EQ(curve.end, CurveEnd::lost);
  EXPECT_NEAR(curve.points.back().at.x, 0.0, 6e-9 * 2.0);  // twice the least step, of a box of 6
  EXPECT_GE(curve.points.back().at.x, 0.0);
}

// In frequency at r = 0.7, on the edges of sticking away from there, and in the stops: on the
// curve, and a few steps on, the count of the sticking phases changes.
TEST(BifurcationCurves, AreWhereTheCountsChange) {
  int curves = 0;
  for (const CurveStart &start : curve_starts()) {
    if (start.plane != "5c" && start.plane != "omega_r") continue;
    SCOPED_TRACE(start.name);
    const StartedCurve found = started(start);
    const FollowedCurve curve =
        follow_curve(corrector_of(found.curve), found.point, found.plane.box, 1,
                     {.step = 0.01, .turn = 0.3, .most = 4});
    ASSERT_EQ(curve.points.size(), 4u);
    for (const CurvePoint &point : {curve.points.front(), curve.points.back()}) {
      const auto distance = distance_by_counting(found.curve, point, found.plane.box);
      ASSERT_TRUE(distance) << point.at.x << " " << point.at.y;
      EXPECT_LT(*distance, 1e-9) << point.at.x << " " << point.at.y;
    }
    ++curves;
  }
  EXPECT_EQ(curves, 24);
}

// The direction of a curve is that of the derivatives of what is zero on it: against the secant of
// two points of it, 2 h apart around it (an error of h^2).
TEST(BifurcationCurves, RunAsTheDerivativesSay) {
  for (const char *name : {"multi_sliding_mass_2", "border_mass_1_3"}) {
    const StartedCurve found = started(start_named(name));
    const Corrector corrector = corrector_of(found.curve);
    const double h = 1e-5, x = found.point.at.x;
    const auto above = corrector({x, 0.7 + h}, {1.0, 0.0}, found.point),
               below = corrector({x, 0.7 - h}, {1.0, 0.0}, found.point);
    ASSERT_TRUE(above && below) << name;
    const double secant = (above->at.x - below->at.x) / (2.0 * h),
                 slope = -found.point.gradient.y / found.point.gradient.x;
    EXPECT_NEAR(secant, slope, 1e-4 * std::max(1.0, std::abs(slope))) << name;
  }
}

// The border orbits of both masses on one orbit: there the curve of either ends, as the sticks of
// the other mass change, and they end at one point. Eight digits.
TEST(BifurcationCurves, OfTwoMassesEndWhereTheyMeet) {
  std::vector<PlanePoint> ends;
  for (const char *name : {"border_mass_2_3", "border_mass_1_6"}) {
    const StartedCurve found = started(start_named(name));
    const FollowedCurve curve =
        follow_curve(corrector_of(found.curve), found.point, found.plane.box, -1,
                     {.step = 0.015, .least_step = 1e-8, .turn = 0.3});
    EXPECT_EQ(curve.end, CurveEnd::events) << name;
    ends.push_back(curve.points.back().at);
  }
  ASSERT_EQ(ends.size(), 2u);
  for (const PlanePoint &end : ends) {
    EXPECT_NEAR(end.x, 0.40385105, 2e-8);
    EXPECT_NEAR(end.y, 0.70001333, 2e-8);
  }
}

// Beside the border orbits of mass 1 at 0.3678 of period two lies that of period one: their curves
// end before it, every point with period two.
TEST(BifurcationCurves, OfAPeriodTwoOrbitKeepThatPeriod) {
  for (const char *name : {"border_mass_1_4", "border_mass_1_5"}) {
    const StartedCurve found = started(start_named(name));
    for (const int direction : {1, -1}) {
      const FollowedCurve curve = follow_curve(corrector_of(found.curve), found.point,
                                               found.plane.box, direction, {.turn = 0.3});
      EXPECT_NE(curve.end, CurveEnd::most) << name;
      for (const CurvePoint &point : curve.points) {
        EXPECT_EQ(point.period, 2) << name << " " << point.at.x;
        EXPECT_LT(point.at.x, 0.368) << name;
      }
    }
  }
}

// Mass 2 of Figure 5(b) grazes: through the point of one parameter in frequency, and in the plane
// of the stops.
TEST(BifurcationCurves, GrazingOfFigure5b) {
  const References stored = read_references(REFERENCE_DIR "/bifurcation_points.csv");
  const Scene scene = paper::figure5b();
  const MotionState seed = at_quiet_phase(scene, state_after_periods(scene, 200));
  BifurcationCurve curve{Bifurcation::grazing,           scene, parameter_named("omega"),
                         parameter_named("restitution"), 1,     1};
  const auto point = point_of(curve, {0.2995, 0.001}, {-1.0, 0.0}, seed);
  ASSERT_TRUE(point);
  EXPECT_NEAR(point->at.x, stored.at("grazing_mass_2_figure5b").value, 1e-13);

  curve.x = parameter_named("stop1");
  curve.y = parameter_named("stop2");
  const auto start = point_of(curve, {0.3, 0.45}, {0.0, 1.0}, seed);
  ASSERT_TRUE(start);
  const FollowedCurve found = follow_curve(corrector_of(curve), *start, {0.28, 0.32, 0.4, 0.5}, 1);
  EXPECT_EQ(found.end, CurveEnd::box);
  // On the curve the highest displacement of mass 2, where its stop is far away, is s2.
  Scene without = curve.at({found.points.back().at.x, 0.6});
  const MotionState orbit =
      orbit_near(without, at_quiet_phase(without, state_after_periods(without, 200)), 1);
  EXPECT_NEAR(least_gap(without, orbit, without.stops[1]).value().value,
              0.6 - found.points.back().at.y, 1e-11);
}

}  // namespace
