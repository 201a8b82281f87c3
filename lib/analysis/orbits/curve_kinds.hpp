// A point of a bifurcation curve, kind by kind: what the correctors of bifurcation_curve.cpp are
// made of.
#pragma once

#include "vibro_impact/analysis/bifurcation_curve.hpp"
#include "vibro_impact/analysis/border_orbit.hpp"

namespace vibro_impact {

// What is zero on the curve, at a point beside it.
struct Condition {
  double value = 0.0;
  PlanePoint gradient;
  MotionState state;
  double time = 0.0;
  EventSequence events;
};

// The time at the same angle of the forcing in another scene.
inline double same_angle(double time, const Scene &from, const Scene &to) {
  return time * from.omega / to.omega;
}

// The events of an orbit that say which curve a point is on (BifurcationCurve), of all its events;
// `on_border`: the chatter that is left out, with the stick and the release after it.
EventSequence sequence_of(const BifurcationCurve &curve, const std::vector<Event> &events,
                          const Chatter *on_border = nullptr);

// A reading at `read`, very near, made a point of the curve, at a section far from events.
CurvePoint point_from(const BifurcationCurve &curve, const PlanePoint &at, const PlanePoint &read,
                      const Condition &reading, double error);

// Border orbits (border_curve.cpp): orbit and place on the line together, by Newton's method from a
// motion near the border orbit; `from.at` is that of its scene.
std::optional<CurvePoint> by_held_chatter(const BifurcationCurve &curve, const PlanePoint &guess,
                                          const PlanePoint &across, const CurvePoint &from);

}  // namespace vibro_impact
