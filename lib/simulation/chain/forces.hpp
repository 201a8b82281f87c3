// The forces of a chain on one of its masses: the one place where the rows of Eq. 4, and so the
// hold forces of Eqs. 12-13, are written out.
#pragma once

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

// The force on mass i (from 0) towards +x (Eq. 4): links, dampers and forcing, by the coordinates
// x(j) and v(j) of the mass itself and its neighbours and the cosine of the forcing. A derivative
// of the force is the force of the same derivative of all three; with the mass at rest at its stop
// it is the hold force (Eqs. 12-13).
template <class Displacements, class Velocities>
double force_on(const Scene &scene, std::size_t i, const Displacements &x, const Velocities &v,
                double cosine) {
  return link_force(scene, i, x(i), x) + scene.beta * link_force(scene, i, v(i), v) +
         amplitude_on(scene, i) * cosine;
}

// A bound of the rate of every contact mode, in units of which derivatives of forces are carried.
double rate_of(const Scene &scene);

// A mode of which the two decays are well apart: damping ratio beta sqrt(lambda) / 2 (Eq. 7).
inline bool strongly_damped(double beta, double lambda) {
  return beta * beta * lambda > 4.0 * strong_damping * strong_damping;
}

}  // namespace vibro_impact
