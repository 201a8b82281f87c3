// A point of a bifurcation curve, kind by kind: what the correctors of bifurcation_curve.cpp are
// made of.
#pragma once

#include "vibro_impact/analysis/bifurcation_curve.hpp"
#include "vibro_impact/analysis/border_orbit.hpp"
#include "vibro_impact/analysis/orbit_change.hpp"

namespace vibro_impact {

// The time at the same angle of the forcing in another scene.
inline double same_angle(double time, const Scene &from, const Scene &to) {
  return time * from.omega / to.omega;
}

// The events of an orbit that say which curve a point is on (BifurcationCurve), of all its events;
// `on_border`: the chatter that is left out, with the stick and the release after it.
EventSequence sequence_of(const BifurcationCurve &curve, const std::vector<Event> &events,
                          const Chatter *on_border = nullptr);

// What was read very near, at a place where the orbit is, made a point of the curve, at a section
// far from events.
CurvePoint point_from(const BifurcationCurve &curve, const PlanePoint &at, CurvePoint reading,
                      double error);

// What is zero on a border orbit: by how much the ratio of the speeds of two consecutive impacts of
// a chatter exceeds that of a border orbit. Its last by.size() derivatives are by these parameters,
// the ones before by what the others of the changes go with.
ValueChange border_excess_change(const Scene &scene, const std::vector<Parameter> &by,
                                 const EventChange &one, const EventChange &next);

// Border orbits (held_chatter.cpp): orbit and place on the line together, by Newton's method from a
// motion near the border orbit; `from.at` is that of its scene.
std::optional<CurvePoint> by_held_chatter(const BifurcationCurve &curve, const PlanePoint &guess,
                                          const PlanePoint &across, const CurvePoint &from);

}  // namespace vibro_impact
