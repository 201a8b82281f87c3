// A curve in a plane followed by pseudo-arclength: a step along the tangent, and a correction
// across it. What the curve is the corrector knows alone (bifurcation_curve.hpp).
#pragma once

#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "vibro_impact/record.hpp"
#include "vibro_impact/simulate.hpp"

namespace vibro_impact {

struct PlanePoint {
  double x = 0.0, y = 0.0;
};

inline PlanePoint moved(const PlanePoint &from, const PlanePoint &direction, double by) {
  return {from.x + by * direction.x, from.y + by * direction.y};
}

// A part of the plane; its sides are the units of length in which steps and angles are measured.
struct PlaneBox {
  double x_from = 0.0, x_to = 1.0, y_from = 0.0, y_to = 1.0;

  bool contains(const PlanePoint &at) const;
  // In units of the box.
  double distance(const PlanePoint &a, const PlanePoint &b) const;
  // Of length one in these units: the direction, in the plane, in which a function with this
  // gradient rises fastest, and the one with that to its left, along which it is constant.
  PlanePoint across(const PlanePoint &gradient) const;
  PlanePoint along(const PlanePoint &gradient) const;
};

// Kinds of the events of a periodic orbit and the stops they are at, in order, from wherever on the
// orbit makes this list the least.
using EventSequence = std::vector<std::pair<EventKind, std::size_t>>;

// A point of a curve, with what its corrector needs to know to find the next.
struct CurvePoint {
  PlanePoint at;
  PlanePoint gradient;        // across the curve, of any length; always to the same side of it
  double error = 0.0;         // estimated, of `at`
  MotionState state;          // of the orbit, at a section
  double time = 0.0;          // after the section, of the end of the chatter of a border orbit
  int period = 1;             // least period of the orbit, in forcing periods
  EventSequence events = {};  // of the orbit that tell its curve from others
};

// The point of the curve on the line through `guess` in the direction of `across`, near
// `neighbour`, a point of the curve; nothing where it finds none.
using Corrector = std::function<std::optional<CurvePoint>(
    const PlanePoint &guess, const PlanePoint &across, const CurvePoint &neighbour)>;

struct FollowOptions {
  double step = 0.01;        // longest, in units of the box, > 0
  double least_step = 1e-6;  // below which the curve is given up, > 0
  double turn = 0.2;         // largest angle between tangents at neighbouring points, > 0
  std::size_t most = 2000;   // points
};

enum class CurveEnd { box, events, lost, closed, most };

// "leaves the box", "events change", "lost", "closed", "most points".
const char *name(CurveEnd end);

struct FollowedCurve {
  std::vector<CurvePoint> points;  // the start first
  CurveEnd end = CurveEnd::lost;
};

// The curve from `start` on, with its gradient to the left (`direction` +1) or to the right (-1) of
// the way, as long as the orbit keeps its events and its least period: where they change there is
// another curve, or this one with a corner. A last point on the side of the box where it leaves it.
// Throws std::invalid_argument for an empty box, a start outside it, and options out of range.
FollowedCurve follow_curve(const Corrector &corrector, const CurvePoint &start, const PlaneBox &box,
                           int direction, const FollowOptions &options = {});

}  // namespace vibro_impact
