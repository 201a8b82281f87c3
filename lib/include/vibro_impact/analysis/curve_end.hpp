// Where a curve of bifurcations ends, and what falls to zero there: a point of codimension two.
//
// Following gives a curve up where its corrector finds nothing any more. What is zero there is
// positive on the curve, so that it is extrapolated along it, from points ever nearer.
#pragma once

#include <string>

#include "bifurcation_curve.hpp"

namespace vibro_impact {

// Of a curve of bifurcations:
//   "grazing of mass 1"       the speed of the slowest of its impacts outside complete chatters,
//                             or the least gap between impacts
//   "border orbit of mass 1"  the square of the shortest of its sticking phases
//   "fold"                    1 minus the largest real Floquet multiplier (not of a curve of folds)
//   "beginning of the phase"  multi-sliding: the time of the least force after the beginning
//   "end of the phase"        multi-sliding: the square of the time from there to the release,
//                             where the minimum meets a maximum
//   "cusp"                    a fold: the derivative by the speed of what is zero on it
//   "impact of mass 2 at the limit"  border orbit: the time from the limit of the chatter to the
//                             nearest impact of another mass
//   "force without rate"      border orbit: how fast the pressing force falls at the limit
//   "no restitution"          border orbit: the square root of r, with which the place goes
//   "double impact"           the least time between impacts of two masses; passable
EndConditions end_conditions(const BifurcationCurve &curve);

struct LocatedEnd {
  std::string condition;
  PlanePoint at;
  double error = 0.0;  // estimated, of `at`, in units of the box
  double value = 0.0;  // of the condition at the last point that was found
};

// The end that a curve followed with these conditions leads to, from two points at least: of the
// conditions that fall along the last of them that which reaches zero first; its zero from an
// interpolation through ever nearer points, as near as the corrector finds any. Nothing where none
// falls, or where the interpolations of two orders do not agree to 1e-5. Throws
// std::invalid_argument for fewer points and for a curve followed without these conditions.
std::optional<LocatedEnd> end_of(const Corrector &corrector, const EndConditions &conditions,
                                 const FollowedCurve &curve, const PlaneBox &box);

// Where a curve goes on beyond an end, and in which direction from there.
struct Beyond {
  CurvePoint point;
  int direction = 1;
};

// The same beyond an end that `last`, the last point before it, leads to: at a grazing the orbit
// goes on with an impact more or less, at a border orbit with another chatter that does not
// complete any more, and the curve with it, mostly with a corner. It is looked for around the end,
// but for the way it came, up to 0.01 away in units of the box, from the motion that the orbit has
// become there. Nothing at other ends, where none is found, and for period doublings and folds.
std::optional<Beyond> beyond(const BifurcationCurve &curve, const LocatedEnd &end,
                             const CurvePoint &last, const PlaneBox &box);

}  // namespace vibro_impact
