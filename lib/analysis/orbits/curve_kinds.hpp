// A point of a bifurcation curve, kind by kind: what the correctors of bifurcation_curve.cpp are
// made of.
#pragma once

#include "vibro_impact/analysis/bifurcation_curve.hpp"

namespace vibro_impact {

// Kinds followed as families by the speed of an impact.
inline bool of_impacts(Bifurcation what) {
  return what == Bifurcation::period_doubling || what == Bifurcation::fold;
}

// What is zero on the curve at a point beside it.
struct Condition {
  double value = 0.0;
  PlanePoint gradient;
  MotionState state;
  double time = 0.0;
};

inline PlanePoint moved(const PlanePoint &from, const PlanePoint &direction, double by) {
  return {from.x + by * direction.x, from.y + by * direction.y};
}

inline double along(const PlanePoint &gradient, const PlanePoint &direction) {
  return gradient.x * direction.x + gradient.y * direction.y;
}

// The time at the same angle of the forcing in another scene.
inline double same_angle(double time, const Scene &from, const Scene &to) {
  return time * from.omega / to.omega;
}

// The orbit from a neighbouring motion of scene `from`: by Newton's method, or where that fails,
// from the motion followed for a while.
std::optional<PeriodicOrbit> orbit_in(const Scene &scene, const Scene &from, MotionState seed,
                                      int periods, const RunOptions &run);

// The least time between impacts of two masses, of events in their order.
double time_apart(const std::vector<Event> &events);

// A reading at `read`, very near, made a point of the curve, at a section far from events.
CurvePoint point_from(const BifurcationCurve &curve, const PlanePoint &at, const PlanePoint &read,
                      const Condition &reading, double error);

// Multi-sliding and grazing (one_sided_curve.cpp): on the line through `guess`, from the side where
// the value is positive, the direction `side` of `across`; from a motion of scene `from`. `count`:
// of what happens on that side, any if negative.
std::optional<CurvePoint> from_one_side(const BifurcationCurve &curve, const PlanePoint &guess,
                                        const PlanePoint &across, const Scene &from,
                                        const MotionState &start, double side, int count);

// Border orbits (border_curve.cpp): orbit and place on the line together, by Newton's method from a
// motion near the border orbit; `from.at` is that of its scene.
std::optional<CurvePoint> by_held_chatter(const BifurcationCurve &curve, const PlanePoint &guess,
                                          const PlanePoint &across, const CurvePoint &from);

// A point of a curve of border orbits: the events of the orbit but for the impacts of the chatter,
// its multipliers with that chatter complete, when it ends after the section, and the rate of the
// pressing force there, which falls.
struct OnBorder {
  std::vector<Event> events;
  std::vector<std::complex<double>> multipliers;
  double end = 0.0, press_rate = 0.0;
  double apart =
      0.0;  // the least time between impacts of two masses, the first of the chatter, too
};
std::optional<OnBorder> on_border(const BifurcationCurve &curve, const CurvePoint &point);

// Period doublings and folds (impact_curve.cpp): by Newton's method in the speed of an impact and
// the place on the line.
std::optional<CurvePoint> by_speed(const BifurcationCurve &curve, const PlanePoint &guess,
                                   const PlanePoint &across, ImpactOrbit orbit);

// The orbit of the family in x at a point of such a curve.
ImpactOrbit impact_orbit_at(const BifurcationCurve &curve, const CurvePoint &point);

}  // namespace vibro_impact
