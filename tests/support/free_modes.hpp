// The modes of the free masses, by the decomposition of the generator, which shares nothing with
// the library's: an eigenvalue problem solved in 50 digits, so that links of 1e-9 to 1e9 between
// masses of 1e-6 to 1e6 leave 20 of them; used in extended precision.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <vector>

#include "reference/generator/closed_form.hpp"
#include "vibro_impact/record.hpp"
#include "vibro_impact/scene.hpp"

namespace vibro_impact::testing {

using Real = long double;
using RealVector = Eigen::Matrix<Real, Eigen::Dynamic, 1>;

// Modes of the free masses, normalised to unit modal mass: x = shape q on the free masses.
struct FreeModes {
  RealVector lambda;        // w_j^2
  RealVector cosine, sine;  // of the forcing
  RealVector pull;          // of the held masses and the constant forces
  Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic> shape, inverse;  // N x modes, modes x N
};

inline FreeModes free_modes(const Scene &scene, const Held &held) {
  using Eigen::Index, vibro_impact_reference::Field;
  const auto digits = vibro_impact_reference::in_digits(scene, 0.0);
  const vibro_impact_reference::Matrix k = vibro_impact_reference::stiffness_matrix(digits);
  std::vector<std::size_t> free;
  for (std::size_t i = 0; i < held.size(); ++i)
    if (held[i] == 0) free.push_back(i);
  const auto n = static_cast<Index>(held.size()), modes = static_cast<Index>(free.size());
  RealVector pull = RealVector::Zero(n);
  for (const std::size_t i : free)
    pull(static_cast<Index>(i)) = static_cast<Real>(digits[&Field::constant][i]);
  for (const Stop &stop : scene.stops) {
    const auto s = static_cast<std::size_t>(stop.mass - 1);
    if (held[s] != static_cast<signed char>(stop.side)) continue;
    for (const std::size_t i : free)
      pull(static_cast<Index>(i)) -= static_cast<Real>(k[i][s]) * stop.position;
  }
  FreeModes basis;
  basis.lambda.setZero(modes);
  basis.cosine.setZero(modes);
  basis.sine.setZero(modes);
  basis.pull.setZero(modes);
  basis.shape.setZero(n, modes);
  basis.inverse.setZero(modes, n);
  if (modes == 0) return basis;
  const bool tied = scene.stiffness[0] > 0.0 ||
                    std::ranges::any_of(scene.ground, [](double g) { return g > 0.0; });
  // The frequency of the rigid-body mode is zero exactly.
  auto eigen = vibro_impact_reference::free_eigensystem(digits, k, free);
  if (!tied && free.size() == held.size()) *std::ranges::min_element(eigen.values) = 0;
  for (Index j = 0; j < modes; ++j) {
    const auto mode = static_cast<std::size_t>(j);
    basis.lambda(j) = static_cast<Real>(eigen.values[mode]);
    for (std::size_t a = 0; a < free.size(); ++a) {
      const std::size_t i = free[a];
      const auto row = static_cast<Index>(i);
      basis.shape(row, j) = static_cast<Real>(eigen.vectors[a][mode]);
      basis.inverse(j, row) = basis.shape(row, j) * scene.mass[i];
      basis.pull(j) += basis.shape(row, j) * pull(row);
      basis.cosine(j) += basis.shape(row, j) * static_cast<Real>(digits[&Field::amplitude][i]);
      basis.sine(j) += basis.shape(row, j) * static_cast<Real>(digits[&Field::sine][i]);
    }
  }
  return basis;
}

}  // namespace vibro_impact::testing
