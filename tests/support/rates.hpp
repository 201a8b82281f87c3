// Bounds of the rates of a chain, as tests need them.
#pragma once

#include <algorithm>
#include <cmath>

#include "vibro_impact/scene.hpp"

namespace vibro_impact::testing {

// Gershgorin's bound of the eigenvalues of the chain, which holds for every contact mode.
inline double largest_eigenvalue_bound(const Scene &scene) {
  double bound = 0.0;
  for (std::size_t i = 0; i < scene.mass.size(); ++i) {
    const double right = i + 1 < scene.mass.size() ? scene.stiffness[i + 1] : 0.0;
    const double ground = scene.ground.empty() ? 0.0 : scene.ground[i];
    bound = std::max(bound, (2.0 * (scene.stiffness[i] + right) + ground) / scene.mass[i]);
  }
  return bound;
}

// The rate of the fastest mode is at most this.
inline double frequency_bound(const Scene &scene) {
  return std::sqrt(largest_eigenvalue_bound(scene));
}

// Largest modulus of a root of z^2 + kappa z + lambda: the rate of a damped mode.
inline double root_modulus(double kappa, double lambda) {
  const double alpha = kappa / 2, discriminant = alpha * alpha - lambda;
  return discriminant > 0 ? alpha + std::sqrt(discriminant) : std::sqrt(lambda);
}

}  // namespace vibro_impact::testing
