// How a periodic orbit, its events and what is zero at its bifurcations change with parameters of
// the scene: what following an orbit in a parameter needs. All at a fixed phase of the section
// (tangent.hpp), so that a change of Omega moves the section with the period.
//
// For z = P(z, p), dz/dp = (1 - P_z)^-1 P_p. The derivative of anything along the orbit is then a
// run with that as the change of the start; of a minimum over time, it is that at a fixed time.
#pragma once

#include <optional>
#include <vector>

#include "parameter.hpp"
#include "periodic_orbit.hpp"
#include "tangent.hpp"

namespace vibro_impact {

struct OrbitChange {
  std::vector<Parameter> by;
  Matrix state;                     // 2N x parameters: of the orbit at the section
  std::vector<EventChange> events;  // of the orbit's periods after it; one entry per parameter
};

// Throws std::invalid_argument for an orbit that has not converged, for no parameters and for those
// that TangentRecorder rejects, std::runtime_error where a Floquet multiplier is 1: at a fold the
// orbit has no derivative.
OrbitChange orbit_change(const Scene &scene, const PeriodicOrbit &orbit,
                         const std::vector<Parameter> &by, const RunOptions &options = {});

// A value and its derivatives by the parameters of an OrbitChange.
struct ValueChange {
  double value = 0.0;
  std::vector<double> by;
};

// Those of least_gap and least_pressing_force (multi_sliding.hpp) on the orbit: zero at a grazing
// and at a multi-sliding bifurcation. `stop` is a stop of the scene or, for the gap, any other,
// which then stands still. To be asked away from a minimum that is about to disappear.
std::optional<ValueChange> least_gap_change(const Scene &scene, const PeriodicOrbit &orbit,
                                            const OrbitChange &change, const Stop &stop);
std::optional<ValueChange> least_pressing_force_change(const Scene &scene,
                                                       const PeriodicOrbit &orbit,
                                                       const OrbitChange &change, const Stop &stop);

}  // namespace vibro_impact
