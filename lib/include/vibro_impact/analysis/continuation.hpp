// A curve in a plane followed by pseudo-arclength: a step along the tangent, and a correction
// across it. What the curve is the corrector knows alone (bifurcation_curve.hpp).
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "vibro_impact/simulate.hpp"

namespace vibro_impact {

struct PlanePoint {
  double x = 0.0, y = 0.0;
};

// A part of the plane; its sides are the units of length in which steps and angles are measured.
struct PlaneBox {
  double x_from = 0.0, x_to = 1.0, y_from = 0.0, y_to = 1.0;
};

// A point of a curve, with what its corrector needs to know to find the next.
struct CurvePoint {
  PlanePoint at;
  PlanePoint gradient;  // across the curve, of any length; the side it points to stays the same
  double error = 0.0;   // estimated, of `at`
  MotionState state;    // of the orbit, at a section
  double time = 0.0;    // after the section, of what is zero there
  int count = -1;       // of what happens on the side where the motion is followed
  double speed = 0.0;   // of the impact that is the section of a period doubling or a fold
};

// The point of the curve on the line through `guess` in the direction of `across`, near
// `neighbour`, a point of the curve; nothing where it finds none.
using Corrector = std::function<std::optional<CurvePoint>(
    const PlanePoint &guess, const PlanePoint &across, const CurvePoint &neighbour)>;

// Quantities positive on a curve that may be zero at its end, by name; NaN where one means nothing.
struct EndConditions {
  std::vector<std::string> names = {};
  std::function<std::vector<double>(const CurvePoint &)> values = {};
  std::size_t passable = 0;  // of them, the last: the curve may go on smoothly, or nearly so
};

struct FollowOptions {
  double step = 0.01;        // longest, in units of the box, > 0
  double least_step = 1e-6;  // below which the curve is given up, > 0
  double turn = 0.2;         // largest angle between tangents at neighbouring points, > 0
  std::size_t most = 2000;   // points
};

enum class CurveEnd { box, lost, closed, most };

// "leaves the box", "lost", "closed", "most points".
const char *name(CurveEnd end);

struct FollowedCurve {
  std::vector<CurvePoint> points;           // the start first
  std::vector<std::vector<double>> values;  // of the conditions, one row per point
  CurveEnd end = CurveEnd::lost;
};

// The curve from `start` on, with its gradient to the left (`direction` +1) or to the right (-1) of
// the way. A last point on the side of the box where it leaves it. Throws std::invalid_argument for
// an empty box, a start outside it, and options out of range.
//
// A condition that is not passable, falls and is small, below 0.05 and 30 steps, may not change by
// more than a factor of three in one step: towards its zero the steps grow shorter, and none leads
// to what lies behind.
FollowedCurve follow_curve(const Corrector &corrector, const CurvePoint &start, const PlaneBox &box,
                           int direction, const FollowOptions &options = {},
                           const EndConditions &conditions = {});

// The point where two curves cross, near points of both, by Newton's method; nothing where a
// corrector finds none or it does not converge to `tolerance` within 12 steps. The two points are
// those of the curves there.
struct Crossing {
  CurvePoint one, other;
  double error = 0.0;  // the last step
};
std::optional<Crossing> crossing_of(const Corrector &one, const Corrector &other,
                                    const CurvePoint &near_one, const CurvePoint &near_other,
                                    const PlaneBox &box, double tolerance = 1e-10);

}  // namespace vibro_impact
