// Internal parts of `vibro_impact/scene.hpp`: checks, and bounds of the rates of a chain.
#pragma once

#include <cstddef>
#include <vector>

#include "vibro_impact/scene.hpp"

namespace vibro_impact::detail {

// Entry i of a list of a scene that may be left empty.
inline double entry_of(const std::vector<double> &values, std::size_t i) {
  return values.empty() ? 0.0 : values[i];
}

// Throws unless 0 <= phase < T, and every held mass has the stop at which it is held.
void check_place(const Scene &scene, const Instant &instant, const Held &held);

// The initial motion of a scene, with neither of them checked.
MotionState first_motion(const Scene &scene);

// Gershgorin's bound of the eigenvalues of the chain (squares of its natural frequencies). It holds
// for every contact mode: holding masses keeps the eigenvalues between those of the free chain.
double largest_eigenvalue_bound(const Scene &scene);

// Largest modulus of a root of z^2 + kappa z + lambda: the rate of a damped mode.
double root_modulus(double kappa, double lambda);

// A bound of the rates of all contact modes and of the forcing, or 1 if all are zero.
double rate_bound(const Scene &scene);

}  // namespace vibro_impact::detail
