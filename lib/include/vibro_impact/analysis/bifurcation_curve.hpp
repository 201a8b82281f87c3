// Bifurcations of periodic orbits in the plane of two parameters: where the least pressing force
// inside a sticking phase is zero (multi-sliding), where a chatter just fails to complete (border
// orbit), where the least gap is zero (grazing). Their points on a line, of one parameter or any
// other, and the curves through these. The orbit is solved for inside; how what is zero changes
// with the parameters is that of orbit_change.hpp.
#pragma once

#include "continuation.hpp"
#include "parameter.hpp"

namespace vibro_impact {

enum class Bifurcation { multi_sliding, border_orbit, grazing };

// "multi-sliding", "border orbit", "grazing".
const char *name(Bifurcation bifurcation);

// Its orbits keep their sticks and releases (CurvePoint::events), but for those after the chatter
// that is on the border; of a grazing, also the impacts at its stop outside complete chatters.
// Where another impact comes or goes by a grazing the curve has a corner, and is the same.
struct BifurcationCurve {
  Bifurcation what = Bifurcation::multi_sliding;
  Scene scene;           // but for the parameters x and y
  Parameter x, y;        // as TangentRecorder takes them
  std::size_t stop = 0;  // of the phase, the chatter, the gap: index in Scene::stops
  int periods = 1;       // of the orbit

  Scene at(const PlanePoint &point) const;
};

// What finds the points of the curve. A multi-sliding and a grazing are approached from the side
// where the phase is whole, or the stop not touched, because the motion is another on the other
// side: `error` is that of the last, linear, step. A border orbit is a zero for every depth of the
// chatter, and converges with it to rounding. Throws std::invalid_argument for a stop that the
// scene does not have.
Corrector corrector_of(const BifurcationCurve &curve);

// A first point of the curve on the line through `guess` in direction `across`, which points to
// where the phase is whole, the stop not touched, the chatter complete; from a motion near the
// orbit. `time`: of the end of the chatter of a border orbit, after the section. Nothing where it
// finds none. Throws std::invalid_argument for a scene, a stop or parameters out of range.
std::optional<CurvePoint> point_of(const BifurcationCurve &curve, const PlanePoint &guess,
                                   const PlanePoint &across, const MotionState &seed,
                                   double time = 0.0);

}  // namespace vibro_impact
