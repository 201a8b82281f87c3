// The end of a chatter differentiated by parameters: its limit by r, and its time in closed form.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "reference/paper_scenes.hpp"
#include "vibro_impact/analysis/analysis.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace {

using namespace vibro_impact;
using Kind = Parameter::Kind;

double largest_difference(const Matrix &a, const Matrix &b) {
  double most = 0.0;
  for (std::size_t i = 0; i < a.values.size(); ++i)
    most = std::max(most, std::abs(a.values[i] - b.values[i]));
  return most;
}

// By r the changes of late impacts are no power series of the time left. Extrapolated as such they
// would be off by up to 7e-10 here; as they are, a limit taken early and one taken from impacts a
// thousand times slower agree to rounding.
TEST(ChatterByParameters, DoesNotDependOnWhereChatterIsCarriedToItsLimit) {
  for (const double r : {0.5, 0.7, 0.85})
    for (const Scene &paper_scene : {paper::figure2(), paper::figure5a()}) {
      const Scene scene = with(paper_scene, {Kind::restitution, 0}, r);
      const MotionState at = at_quiet_phase(scene, state_after_periods(scene, 30));
      const std::vector<Parameter> by{{Kind::restitution, 0}, {Kind::beta, 0}};
      const StroboscopicImage early = stroboscopic_map_and_derivative(scene, at, 1, {}, by),
                              late = stroboscopic_map_and_derivative(scene, at, 1,
                                                                     {.resolve_chatter = 1e-6}, by);
      EXPECT_LT(largest_difference(early.by_parameters, late.by_parameters), 1e-13) << r;
      EXPECT_LT(largest_difference(early.derivative, late.derivative), 1e-11) << r;
      EXPECT_LT(early.chatter_error, 1e-11) << r;
    }
}

// A ball dropped from h above a floor at s, under its weight -A: it comes to rest at
// sqrt(2 (h - s) m / g) (1 + r) / (1 - r), g = -A; every derivative in closed form, also by r,
// where the late impacts are no power series of the time left.
TEST(ChatterByParameters, OfABouncingBallIsThatOfTheClosedForm) {
  for (const double r : {0.2, 0.5, 0.9}) {
    Scene ball;
    ball.mass = {2.0};
    ball.stiffness = {0.0};
    ball.amplitude = {-3.0};
    ball.omega = 0.0;
    ball.restitution = r;
    ball.displacement = {1.5};
    ball.stops = {{1, Side::lower, 0.25}};
    const std::vector<Parameter> by{
        {Kind::restitution, 0}, {Kind::stop, 1}, {Kind::amplitude, 1}, {Kind::mass, 1}};
    const MotionState start = start_of(ball);
    TangentRecorder tangents(ball, start, Matrix(2, by.size()), {.by = by, .events = true});
    const Outcome end = simulate(ball, 100.0, {}, tangents);
    const ChangesAtEnd at_end = tangents.finish(end.state.instant);
    const EventChange first = at_end.events.front(), last = at_end.events.back();
    ASSERT_EQ(last.event.kind, EventKind::stick);
    const double fall = std::sqrt(2.0 * 1.25 * 2.0 / 3.0), whole = (1.0 + r) / (1.0 - r);
    const double rest = fall * whole, speed = std::sqrt(2.0 * 1.25 * 3.0 / 2.0);
    EXPECT_NEAR(last.event.time, rest, 1e-13 * rest);
    const double by_r = 2.0 * fall / ((1.0 - r) * (1.0 - r));
    // Every flight is a parabola: what an impact predicts is exact. Its rounding remains, which the
    // differences of closely spaced nodes (r = 0.9) make a few 1e-12.
    EXPECT_NEAR(last.time[0] / by_r, 1.0, 1e-11) << r;
    EXPECT_NEAR(last.time[1] / (-rest / 2.5), 1.0, 1e-11) << r;
    EXPECT_NEAR(last.time[2] / (rest / 6.0), 1.0, 1e-11) << r;
    EXPECT_NEAR(last.time[3] / (rest / 4.0), 1.0, 1e-11) << r;
    // The first impact, at -speed: no limit, rounding only.
    EXPECT_EQ(first.time[0], 0.0);
    EXPECT_NEAR(first.time[1], -fall / 2.5, 1e-15);
    EXPECT_NEAR(first.velocity_before[1], speed / 2.5, 2e-15);
    EXPECT_NEAR(first.velocity_before[2], speed / 6.0, 2e-15);
    // Held, it moves with its stop and by nothing else.
    EXPECT_EQ(at_end.changes.values, (std::vector<double>{0, 1, 0, 0, 0, 0, 0, 0}));
  }
}

}  // namespace
