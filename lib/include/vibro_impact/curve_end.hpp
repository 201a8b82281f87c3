// Where a curve of bifurcations ends, and what falls to zero there: a point of codimension two.
//
// Following gives a curve up where its corrector finds nothing any more. What is zero there is
// positive on the curve, so that it is extrapolated along it, from points ever nearer.
#pragma once

#include <string>

#include "bifurcation_curve.hpp"

namespace vibro_impact {

// A quantity positive on a curve, that may be zero at its end; NaN where it means nothing.
struct EndCondition {
  std::string name;
  std::function<double(const CurvePoint &)> value;
};

// Of a curve of bifurcations:
//   "grazing of mass 1"       the speed of the slowest of its impacts outside complete chatters,
//                             or the least gap between impacts
//   "fold"                    1 minus the largest real Floquet multiplier (not of a curve of folds)
//   "beginning of the phase"  multi-sliding: the time of the least force after the beginning
//   "end of the phase"        multi-sliding: the square of the time from there to the release,
//                             where the minimum meets a maximum
//   "cusp"                    a fold: the derivative by the speed of what is zero on it
std::vector<EndCondition> end_conditions(const BifurcationCurve &curve);

struct LocatedEnd {
  std::string condition;
  PlanePoint at;
  double error = 0.0;  // estimated, of `at`, in units of the box
  double value = 0.0;  // of the condition at the last point that was found
};

// The end beyond the last of `points`, two at least, which lead to it: of the conditions that fall
// along the last few that which reaches zero first; its zero from an interpolation through ever
// nearer points, as near as the corrector finds any. Nothing where none falls, or where the
// interpolations of two orders do not agree to 1e-5.
std::optional<LocatedEnd> end_of(const Corrector &corrector,
                                 const std::vector<EndCondition> &conditions,
                                 const std::vector<CurvePoint> &points, const PlaneBox &box);

}  // namespace vibro_impact
