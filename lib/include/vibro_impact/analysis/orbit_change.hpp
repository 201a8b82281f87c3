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
  bool differentiable = true;       // see ChangesAtEnd
};

// Throws std::invalid_argument for an orbit that has not converged and for parameters that
// TangentRecorder rejects, std::runtime_error where a Floquet multiplier is 1: at a fold the orbit
// has no derivative.
OrbitChange orbit_change(const Scene &scene, const PeriodicOrbit &orbit,
                         const std::vector<Parameter> &by, const RunOptions &options = {});

// The section predicted to first order where parameter number k (from 0) of `change` is greater by
// `step`: a guess for find_periodic_orbit in that scene.
MotionState predicted(const Scene &scene, const PeriodicOrbit &orbit, const OrbitChange &change,
                      std::size_t k, double step);

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

// What is zero on a border orbit: by how much the ratio of the speeds of two consecutive impacts of
// a chatter exceeds that of a border orbit. Its last by.size() derivatives are by these parameters,
// the ones before by what the others of the changes go with. Throws std::invalid_argument unless
// both are impacts at one stop of which the restitution lies in (0, 1), and of as many changes.
ValueChange border_excess_change(const Scene &scene, const std::vector<Parameter> &by,
                                 const EventChange &one, const EventChange &next);

}  // namespace vibro_impact
