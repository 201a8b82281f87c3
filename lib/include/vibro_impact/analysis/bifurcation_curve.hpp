// Bifurcations of periodic orbits as curves in the plane of two parameters: where the least
// pressing force inside a sticking phase is zero (multi-sliding), where a chatter just fails to
// complete (border orbit), where the least gap is zero (grazing), where a Floquet multiplier is -1
// (period doubling) or +1 (fold). The orbit is solved for inside; how what is zero changes with the
// parameters is that of orbit_change.hpp or, for the last two, of a family by impact speed.
#pragma once

#include "continuation.hpp"
#include "impact_family.hpp"
#include "orbit_change.hpp"

namespace vibro_impact {

enum class Bifurcation { multi_sliding, border_orbit, grazing, period_doubling, fold };

// "multi-sliding", "border orbit", "grazing", "period doubling", "fold".
const char *name(Bifurcation bifurcation);

struct BifurcationCurve {
  Bifurcation what = Bifurcation::multi_sliding;
  Scene scene;           // but for the parameters x and y
  Parameter x, y;        // as TangentRecorder takes them
  std::size_t stop = 0;  // of the phase, the chatter, the gap, the impact: index in Scene::stops
  int periods = 1;       // of the orbit

  Scene at(const PlanePoint &point) const;
};

// What finds the points of the curve: see bifurcation_curve.cpp for how. A multi-sliding and a
// grazing are approached from the side where the phase is whole, or the stop not touched, because
// the motion is another on the other side: `error` is that of the last, linear, step. A border
// orbit is a zero for every depth of the chatter, which converges with it. A period doubling and a
// fold are zeros of smooth functions of the speed of an impact and one of the parameters (x is then
// the parameter of the ImpactFamily); they end where the orbit is no longer real.
Corrector corrector_of(const BifurcationCurve &curve);

// A first point of the curve on the line through `guess` in direction `across`, which points to
// where the phase is whole, the stop not touched, the chatter complete; from a motion near the
// orbit. `time`: of the end of the chatter of a border orbit, after the section. Throws
// std::invalid_argument for a period doubling or a fold.
std::optional<CurvePoint> point_of(const BifurcationCurve &curve, const PlanePoint &guess,
                                   const PlanePoint &across, const MotionState &seed, double time);

// The same of a period doubling or a fold, from an orbit near it of the family in x, of
// curve.scene: at the y of that scene. Throws std::invalid_argument for other kinds.
std::optional<CurvePoint> point_of(const BifurcationCurve &curve, const ImpactOrbit &near);

}  // namespace vibro_impact
