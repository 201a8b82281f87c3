// The modes of the free masses, by a decomposition that shares nothing with the library's: an
// eigenvalue problem solved in 50 digits, so that links of 1e-9 to 1e9 between masses of 1e-6 to
// 1e6 leave 20 of them; used in extended precision.
#pragma once

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <vector>

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
  using Digits =
      boost::multiprecision::number<boost::multiprecision::cpp_bin_float_50::backend_type,
                                    boost::multiprecision::et_off>;
  using Eigen::Index;
  std::vector<std::size_t> free;
  std::vector<double> held_at(held.size(), 0.0);
  for (std::size_t i = 0; i < held.size(); ++i)
    if (held[i] == 0) free.push_back(i);
  for (const Stop &stop : scene.stops) {
    const auto i = static_cast<std::size_t>(stop.mass - 1);
    if (held[i] == static_cast<int>(stop.side)) held_at[i] = stop.position;
  }
  const auto n = static_cast<Index>(held.size()), modes = static_cast<Index>(free.size());
  Eigen::Matrix<Digits, Eigen::Dynamic, Eigen::Dynamic> k =
      Eigen::Matrix<Digits, Eigen::Dynamic, Eigen::Dynamic>::Zero(modes, modes);
  RealVector pull = RealVector::Zero(modes);
  for (Index a = 0; a < modes; ++a) {
    const std::size_t i = free[static_cast<std::size_t>(a)];
    const auto link = [&](std::size_t other, double stiffness) {  // to a neighbour
      k(a, a) += Digits(stiffness) / scene.mass[i];
      if (held[other] != 0)
        pull(a) += static_cast<Real>(stiffness) * held_at[other];
      else
        k(a, other > i ? a + 1 : a - 1) =
            -Digits(stiffness) / sqrt(Digits(scene.mass[i]) * Digits(scene.mass[other]));
    };
    if (!scene.ground.empty()) k(a, a) += Digits(scene.ground[i]) / scene.mass[i];
    if (!scene.constant.empty()) pull(a) += scene.constant[i];
    if (i == 0)
      k(a, a) += Digits(scene.stiffness[0]) / scene.mass[0];
    else
      link(i - 1, scene.stiffness[i]);
    if (i + 1 < held.size()) link(i + 1, scene.stiffness[i + 1]);
  }
  FreeModes basis;
  basis.lambda.setZero(modes);
  basis.cosine.setZero(modes);
  basis.sine.setZero(modes);
  basis.pull.setZero(modes);
  basis.shape.setZero(n, modes);
  basis.inverse.setZero(modes, n);
  if (modes == 0) return basis;
  const Eigen::SelfAdjointEigenSolver<decltype(k)> solver(k);
  const bool tied =
      scene.stiffness[0] > 0.0 ||
      std::any_of(scene.ground.begin(), scene.ground.end(), [](double g) { return g > 0.0; });
  const bool floats = !tied && free.size() == held.size();
  for (Index j = 0; j < modes; ++j) {
    // The rigid-body mode comes first; its frequency is zero exactly.
    basis.lambda(j) = floats && j == 0 ? 0 : static_cast<Real>(solver.eigenvalues()(j));
    for (Index a = 0; a < modes; ++a) {
      const std::size_t i = free[static_cast<std::size_t>(a)];
      const auto row = static_cast<Index>(i);
      const Digits root = sqrt(Digits(scene.mass[i])), u = solver.eigenvectors()(a, j);
      basis.shape(row, j) = static_cast<Real>(Digits(u / root));
      basis.inverse(j, row) = static_cast<Real>(Digits(u * root));
      basis.pull(j) += basis.shape(row, j) * pull(a);
      if (!scene.amplitude.empty()) basis.cosine(j) += basis.shape(row, j) * scene.amplitude[i];
      if (!scene.sine.empty()) basis.sine(j) += basis.shape(row, j) * scene.sine[i];
    }
  }
  return basis;
}

}  // namespace vibro_impact::testing
