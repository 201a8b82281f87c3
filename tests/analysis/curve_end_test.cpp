// The ends of curves of bifurcations, points of codimension two: closed forms, counts, and two
// curves that lead to one point.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "figures/beyond/curves.hpp"

namespace {

using namespace vibro_impact;
using namespace vibro_impact::figures;

// The right half of an ellipse ends where x = 0: x falls there as the square root of the way left.
TEST(CurveEnd, IsWhereTheConditionIsZero) {
  const Corrector half = [](const PlanePoint &guess, const PlanePoint &across,
                            const CurvePoint &) -> std::optional<CurvePoint> {
    double s = 0.0;
    for (int step = 0; step < 30; ++step) {
      const double x = guess.x + s * across.x, y = guess.y + s * across.y;
      s -= (x * x / 4.0 + y * y - 1.0) / (x * across.x / 2.0 + 2.0 * y * across.y);
    }
    const PlanePoint at{guess.x + s * across.x, guess.y + s * across.y};
    if (!(at.x > 1e-3)) return std::nullopt;
    return CurvePoint{at, {at.x / 2.0, 2.0 * at.y}, 1e-16, {}};
  };
  const PlaneBox plane{-3.0, 3.0, -3.0, 3.0};
  const EndConditions conditions{
      {"y", "x"}, [](const CurvePoint &point) {
        return std::vector<double>{std::abs(point.at.y), point.at.x};  // y rises
      }};
  const FollowedCurve curve = follow_curve(half, {{2.0, 0.0}, {1.0, 0.0}, 0.0, {}}, plane, 1,
                                           {.step = 0.02, .least_step = 1e-3}, conditions);
  const auto end = end_of(half, conditions, curve, plane);
  ASSERT_TRUE(end);
  EXPECT_EQ(end->condition, "x");
  EXPECT_NEAR(end->at.x, 0.0, 1e-9);
  EXPECT_NEAR(std::abs(end->at.y), 1.0, 1e-9);
  const EndConditions rising{
      {"y"}, [](const CurvePoint &point) { return std::vector<double>{std::abs(point.at.y)}; }};
  const FollowedCurve same =
      follow_curve(half, {{2.0, 0.0}, {1.0, 0.0}, 0.0, {}}, plane, 1, {.step = 0.02}, rising);
  EXPECT_FALSE(end_of(half, rising, same, plane));
  EXPECT_THROW(end_of(half, conditions, {{curve.points[0]}, {{0.0, 2.0}}}, plane),
               std::invalid_argument);
  EXPECT_THROW(end_of(half, conditions, same, plane), std::invalid_argument);
}

// No step leads over a zero: a line on which a quantity falls to zero, behind which it is another,
// is followed up to there only.
TEST(CurveEnd, IsNotPassed) {
  const Corrector line = [](const PlanePoint &guess, const PlanePoint &,
                            const CurvePoint &) -> std::optional<CurvePoint> {
    return CurvePoint{{guess.x, 0.0}, {0.0, 1.0}, 1e-16, {}};
  };
  const EndConditions conditions{
      {"distance"}, [](const CurvePoint &point) {
        return std::vector<double>{point.at.x < 0.5003 ? 0.5003 - point.at.x : 0.3};
      }};
  const PlaneBox plane{0.0, 1.0, -1.0, 1.0};
  const FollowedCurve curve = follow_curve(line, {{0.1, 0.0}, {0.0, 1.0}, 0.0, {}}, plane, 1,
                                           {.step = 0.02, .least_step = 1e-6}, conditions);
  EXPECT_EQ(curve.end, CurveEnd::lost);
  EXPECT_LT(curve.points.back().at.x, 0.5003);
  EXPECT_NEAR(curve.points.back().at.x, 0.5003, 1e-5);
  const auto end = end_of(line, conditions, curve, plane);
  ASSERT_TRUE(end);
  EXPECT_NEAR(end->at.x, 0.5003, 1e-12);
}

// A curve of the plane of the atlas, followed one way to its end.
struct OneWay {
  StartedCurve started;
  FollowedCurve curve;
  std::optional<LocatedEnd> end;
};

OneWay to_the_end(const std::string &name, int direction) {
  const CurvePlane plane = omega_r_plane();
  for (const CurveStart &start : curve_starts()) {
    if (start.name != name) continue;
    OneWay way{started(start), {}, {}};
    const Corrector corrector = corrector_of(way.started.curve);
    const EndConditions conditions = end_conditions(way.started.curve);
    const bool border = start.what == Bifurcation::border_orbit;
    way.curve =
        follow_curve(corrector, way.started.point, plane.box, direction,
                     {.step = 0.015, .least_step = border ? 1e-5 : 1e-6, .turn = 0.3}, conditions);
    if (way.curve.end == CurveEnd::lost)
      way.end = end_of(corrector, conditions, way.curve, plane.box);
    return way;
  }
  throw std::invalid_argument(name);
}

// Multi-sliding of mass 1 ends, upwards, where the least force comes at the beginning of the phase:
// just before, it follows it; just beyond there is no minimum inside a phase any more.
TEST(CurveEnd, OfMultiSlidingIsTheBeginningOfThePhase) {
  const auto [found, curve, end] = to_the_end("multi_sliding_mass_1", 1);
  ASSERT_TRUE(end);
  EXPECT_EQ(end->condition, "beginning of the phase");
  EXPECT_NEAR(end->at.x, 0.2560518512, 1e-8);
  EXPECT_NEAR(end->at.y, 0.7437783424, 1e-8);
  const CurvePoint &last = curve.points.back();
  const Corrector corrector = corrector_of(found.curve);
  EXPECT_TRUE(corrector({end->at.x, end->at.y - 1e-8}, {-1.0, 0.0}, last));
  EXPECT_FALSE(corrector({end->at.x, end->at.y + 1e-8}, {-1.0, 0.0}, last));
}

// Multi-sliding of mass 2 cuts a phase in two; the border orbit is where the second part is lost
// again. Downwards both end where the pressing force has a zero, no rate and no curvature: two ways
// to one point. 2e-8: what the first one knows of it.
TEST(CurveEnd, OfMultiSlidingIsThatOfTheBorderOrbitBeside) {
  const OneWay multi_sliding = to_the_end("multi_sliding_mass_2", -1),
               border = to_the_end("border_mass_2_1", -1);
  ASSERT_TRUE(multi_sliding.end && border.end);
  EXPECT_EQ(multi_sliding.end->condition, "end of the phase");
  EXPECT_EQ(border.end->condition, "force without rate");
  EXPECT_LT(border.end->error, 1e-9);
  EXPECT_NEAR(multi_sliding.end->at.x, border.end->at.x, 2e-8);
  EXPECT_NEAR(multi_sliding.end->at.y, border.end->at.y, 2e-8);
}

// Without restitution a mass sticks at its first impact, or not: a count from rest, by bisection.
// The border orbit leads there as the square root of r; 1e-7 is what is known of its end.
TEST(CurveEnd, OfABorderOrbitIsThatWithoutRestitution) {
  const OneWay border = to_the_end("border_mass_1_1", -1);
  ASSERT_TRUE(border.end);
  EXPECT_EQ(border.end->condition, "no restitution");
  const auto sticks = [](double omega) {
    Scene scene = paper::stops_of_different_sign(omega);
    scene.restitution = 0.0;
    EventRecorder told;
    stroboscopic_map(scene, at_quiet_phase(scene, settled(scene, 300)), 1, {}, told);
    return static_cast<int>(std::count_if(
        told.events.begin(), told.events.end(),
        [](const Event &event) { return event.mass == 1 && event.kind == EventKind::stick; }));
  };
  const Change change = bisect(sticks, 0.2586, 0.2587, 1e-12);
  EXPECT_NEAR(border.end->at.x, change.below, 1e-7);
  EXPECT_NEAR(border.end->at.y, 0.0, 1e-7);
}

// The border orbit of mass 1 meets that of mass 2 and goes on beyond it. The end is a point of
// both: the corrector of the other curve finds it, from the last orbit of the first.
TEST(CurveEnd, OfABorderOrbitIsThatOfTheOtherMass) {
  const auto [found, curve, end] = to_the_end("border_mass_1_7", 1);
  ASSERT_TRUE(end);
  EXPECT_EQ(end->condition, "border orbit of mass 2");
  const CurvePoint &last = curve.points.back();
  const PlaneBox box = omega_r_plane().box;
  BifurcationCurve other = found.curve;
  other.stop = 1;
  ShortestStick stick{2};
  const Scene scene = found.curve.at(last.at);
  stroboscopic_map(scene, last.state, 1, {}, stick);
  const auto across = point_of(other, last.at, {0.0, -1.0}, last.state,
                               stick.at - time_of(last.state.instant, Clock(scene.omega)));
  ASSERT_TRUE(across);
  const auto meeting =
      crossing_of(corrector_of(found.curve), corrector_of(other), last, *across, box, 1e-6);
  ASSERT_TRUE(meeting);
  EXPECT_NEAR(end->at.x, meeting->one.at.x, 1e-6);
  EXPECT_NEAR(end->at.y, meeting->one.at.y, 1e-6);
  const auto on = beyond(found.curve, *end, last, box);
  ASSERT_TRUE(on);
  const auto distance = distance_by_counting(found.curve, on->point, box);
  ASSERT_TRUE(distance);
  EXPECT_LT(*distance, 1e-9);
}

// Where an impact of mass 2 grazes it is one of mass 2: its slowest just before the end.
TEST(CurveEnd, NamesTheMassThatGrazes) {
  const auto [found, curve, end] = to_the_end("border_mass_1_2", 1);
  ASSERT_TRUE(end);
  EXPECT_EQ(end->condition, "grazing of mass 2");
  const CurvePoint &last = curve.points.back();
  EventRecorder told;
  stroboscopic_map(found.curve.at(last.at), last.state, found.curve.periods, {}, told);
  double slowest = 1.0;
  for (const Event &event : told.events)
    if (event.mass == 2 && event.kind == EventKind::impact)
      slowest = std::min(slowest, std::abs(event.velocity_before));
  EXPECT_LT(slowest, 1e-4);
  EXPECT_GT(slowest, 0.0);
}

}  // namespace
