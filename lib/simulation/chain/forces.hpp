// The forces of a chain on one of its masses: the one place where the rows of Eq. 4, and so the
// hold forces of Eqs. 12-13, are written out.
#pragma once

#include <cmath>
#include <cstddef>

#include "tolerances.hpp"
#include "vibro_impact/scene.hpp"

namespace vibro_impact {

// Row i (from 0) of -K x with x_i = `at`: the force of the links on mass i. `x(j)` gives x_j and is
// asked of the neighbours only. With velocities in place of displacements, and times beta, it is
// the force of the dampers.
template <class Number, class Coordinates>
Number link_force(const Scene &scene, std::size_t i, Number at, const Coordinates &x) {
  // Differences first: a neighbour at the same position exerts no force at all, not a rounded one.
  Number force = scene.stiffness[i] * ((i > 0 ? x(i - 1) : Number(0)) - at);
  if (i + 1 < scene.mass.size()) force += scene.stiffness[i + 1] * (x(i + 1) - at);
  return force;
}

inline double amplitude_on(const Scene &scene, std::size_t i) {
  return scene.amplitude.empty() ? 0.0 : scene.amplitude[i];
}

// Force on mass i (from 0) towards +x where it stands at `at` without moving, by the displacements
// x(j) and velocities v(j) of its neighbours and the forcing at a time `phase` within its period:
// Eqs. 12-13 for at = s_p.
template <class Displacements, class Velocities>
double force_at_rest(const Scene &scene, std::size_t i, double at, double phase,
                     const Displacements &x, const Velocities &v) {
  return link_force(scene, i, at, x) + scene.beta * link_force(scene, i, 0.0, v) +
         amplitude_on(scene, i) * std::cos(scene.omega * phase);
}

// A mode of which the two decays are well apart: damping ratio beta sqrt(lambda) / 2 (Eq. 7).
inline bool strongly_damped(double beta, double lambda) {
  return beta * beta * lambda > 4.0 * strong_damping * strong_damping;
}

}  // namespace vibro_impact
