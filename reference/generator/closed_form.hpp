// The exact motion between two events: every mode of the free part of the chain in closed form
// (Eqs. 7, 21, 24).
#pragma once

#include "in_digits.hpp"

#include <cstddef>
#include <map>
#include <memory>
#include <vector>

namespace vibro_impact_reference {

/// The stiffness matrix K of Eq. 3 for the whole chain.
Matrix stiffness_matrix(const Scene &scene);

/// Eigenvalues, in no order, and, as columns, eigenvectors.
struct Eigensystem {
  Vector values;
  Matrix vectors;
};

/// One mode, q'' + 2 a q' + lambda q = f cos(Omega t) + g sin(Omega t) + d, as a function of the
/// time since the flow began. Free part: e^{-a tau} (u C(tau) + w S(tau)) with C, S = cos, sin(nu
/// tau)/nu below critical damping, 1, tau at it, and cosh, sinh(nu tau)/nu above it; u and w then
/// are the free displacement and w = u' + a u at tau = 0.
struct Mode {
  enum class Damping { under, critical, over };
  Real lambda;  // omega_n squared
  Real decay;   // a = zeta omega_n
  Real nu;      // sqrt(|lambda - a^2|)
  Damping damping;
  Real forcing, sine_forcing;   // f, g
  Real static_value;            // d / lambda
  Real forced_cos, forced_sin;  // particular solution
  Real secular;                 // undamped at resonance: secular tau sin(Omega t) instead
  Real u, w;
};

/// Motion of every mass at one instant: position and its first three derivatives, and the forcing
/// phase.
struct Motion {
  Vector x, v, a, jerk;
  Real cosine, sine;  // of Omega t
};

/// The flow of one contact mode from one state: the masses in `free` move, the others rest on their
/// stops.
struct Flow {
  Real start_time;
  Real frequency;
  Vector rest_positions;          // of every mass; used for the resting ones
  std::vector<std::size_t> free;  // the moving masses
  std::shared_ptr<const Eigensystem> eigen;
  std::vector<Mode> modes;
};

/// The eigensystem of the free masses of each contact mode met so far, by the resting masses: a
/// large chain is not decomposed again at every event.
using Eigensystems = std::map<std::vector<bool>, std::shared_ptr<const Eigensystem>>;

/// Modes of the masses that do not rest: M^-1/2 K M^-1/2 on their rows. The vectors are
/// mass-normalised: x_free = vectors q.
Eigensystem free_eigensystem(const Scene &scene, const Matrix &k,
                             const std::vector<std::size_t> &free);

/// Builds the flow from positions x and velocities v at time t; `resting[p]` says that mass p is
/// held where it is. An undamped mode driven exactly at its own frequency has no bounded particular
/// solution and gets the growing one.
Flow flow_from(const Scene &scene, const Real &t, const Vector &x, const Vector &v,
               const std::vector<bool> &resting, Eigensystems &known);

/// The fastest rate still in motion a time tau after the start of the flow: the fast decay of an
/// over-damped mode, e^{-(a + nu) tau}, no longer counts once it is below 1e-60 (with 50 digits).
Real fastest_rate_at(const Flow &flow, const Real &tau);

/// The distance at which a flow is sampled: part of a cycle of that rate.
Real sampling_step(const Flow &flow, const Real &tau);

/// The closed form at time tau after the start of the flow.
Motion motion_at(const Flow &flow, const Real &tau);

}  // namespace vibro_impact_reference
