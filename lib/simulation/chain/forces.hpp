// The forces of a chain on one of its masses: the one place where the rows of Eq. 4, and so the
// hold forces of Eqs. 12-13, are written out.
#pragma once

#include <cstddef>

#include "vibro_impact/scene.hpp"

namespace vibro_impact::detail {

// Entry i of a list of a scene that may be left empty.
inline double entry_of(const std::vector<double> &values, std::size_t i) {
  return values.empty() ? 0.0 : values[i];
}

// Row i (from 0) of -K x: the force of the links, and of its spring to the ground, on mass i, which
// stands at `own`. `x(j)` gives x_j and is asked of the neighbours only. With velocities in place
// of displacements, and times beta, it is the force of the dampers.
template <class Coordinates>
double link_force(const Scene &scene, std::size_t i, double own, const Coordinates &x) {
  // Differences first: a neighbour at the same position exerts no force at all, not a rounded one.
  double force = scene.stiffness[i] * ((i > 0 ? x(i - 1) : 0.0) - own);
  if (i + 1 < scene.mass.size()) force += scene.stiffness[i + 1] * (x(i + 1) - own);
  if (!scene.ground.empty()) force -= scene.ground[i] * own;
  return force;
}

// The factors of A_i, B_i and P_i at one instant: cos(Omega t), sin(Omega t) and 1, or the same
// derivative of all three.
struct ForcingFactors {
  double cosine = 0.0, sine = 0.0, constant = 0.0;
};

inline ForcingFactors forcing_at(double cosine, double sine) {
  return {cosine, sine, 1.0};
}

// The external force on mass i (from 0). The kinds of force are put together here alone.
inline double external_force(const Scene &scene, std::size_t i, const ForcingFactors &factors) {
  return entry_of(scene.amplitude, i) * factors.cosine + entry_of(scene.sine, i) * factors.sine +
         entry_of(scene.constant, i) * factors.constant;
}

// The force on mass i (from 0) towards +x (Eq. 4): springs, dampers and external forces, by the
// coordinates x(j) and v(j) of the mass itself and its neighbours. A derivative of the force is the
// force of the same derivative of x, v and the factors. With the mass at rest at its stop it is the
// hold force (Eqs. 12-13).
template <class Displacements, class Velocities>
double force_on(const Scene &scene, std::size_t i, const Displacements &x, const Velocities &v,
                const ForcingFactors &factors) {
  return link_force(scene, i, x(i), x) + scene.beta * link_force(scene, i, v(i), v) +
         external_force(scene, i, factors);
}

// Gershgorin's bound of the eigenvalues of the chain (squares of its natural frequencies). It holds
// for every contact mode: holding masses keeps the eigenvalues between those of the free chain.
double largest_eigenvalue_bound(const Scene &scene);

// Largest modulus of a root of z^2 + kappa z + lambda: the rate of a damped mode.
double root_modulus(double kappa, double lambda);

// A bound of the rates of all contact modes and of the forcing, or 1 if all are zero. It is the
// unit in which derivatives of forces are carried.
double rate_bound(const Scene &scene);

}  // namespace vibro_impact::detail
