// Zeros of several functions of as many unknowns: Broyden's method.
#pragma once

#include "closed_form.hpp"

#include <boost/multiprecision/eigen.hpp>

#include <Eigen/LU>
#include <functional>
#include <stdexcept>

namespace vibro_impact_reference {

using SquareMatrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;

/// Moves `x` to a zero of f, until a step is below `tolerance`; returns that step. `inverse`
/// approximates the inverse of the derivatives: differences where it comes empty, then what every
/// step shows (Broyden's update), so that it serves for a neighbouring f as well. Throws
/// std::runtime_error if forty steps do not do.
inline Real solve(const std::function<Vector(const Vector &)> &f, Vector &x, SquareMatrix &inverse,
                  const Real &tolerance) {
  using Column = Eigen::Matrix<Real, Eigen::Dynamic, 1>;
  const auto size = static_cast<Eigen::Index>(x.size());
  const auto value_at = [&](const Column &at) -> Column {
    const Vector value = f({at.data(), at.data() + size});
    return Column::Map(value.data(), size);
  };
  auto unknowns = Column::Map(x.data(), size);
  Column value = value_at(unknowns);
  if (inverse.size() == 0) {
    SquareMatrix derivatives(size, size);
    const Real h = small(20);
    for (Eigen::Index j = 0; j < size; ++j) {
      Column beside = unknowns;
      beside[j] += h;
      derivatives.col(j) = (value_at(beside) - value) / h;
    }
    inverse = derivatives.inverse();
  }
  for (int iteration = 0; iteration < 40; ++iteration) {
    const Column step = -inverse * value;
    unknowns += step;
    const Real length = step.cwiseAbs().maxCoeff();
    if (length <= tolerance) return length;
    const Column next = value_at(unknowns);
    const Column moved = inverse * (next - value);
    value = next;
    const Real scale = step.dot(moved);
    if (scale == 0) throw std::runtime_error("solve: a step that changes nothing");
    // inverse += (step - inverse change) (step^T inverse) / (step^T inverse change).
    const Column row = inverse.transpose() * step;
    inverse += (step - moved) * row.transpose() / scale;
  }
  throw std::runtime_error("solve: no zero after forty steps");
}

}  // namespace vibro_impact_reference
