// Zeros of several functions of as many unknowns: Broyden's method.
#pragma once

#include "closed_form.hpp"
#include "digits.hpp"

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <utility>

namespace vibro_impact_reference {

/// The inverse of a matrix, by elimination with pivots.
inline Matrix inverse_of(Matrix a) {
  const std::size_t n = a.size();
  Matrix inverse(n, Vector(n));
  for (std::size_t i = 0; i < n; ++i) inverse[i][i] = 1;
  for (std::size_t c = 0; c < n; ++c) {
    std::size_t pivot = c;
    for (std::size_t i = c + 1; i < n; ++i)
      if (abs(a[i][c]) > abs(a[pivot][c])) pivot = i;
    if (a[pivot][c] == 0) throw std::logic_error("inverse_of: a singular matrix");
    std::swap(a[c], a[pivot]);
    std::swap(inverse[c], inverse[pivot]);
    const Real scale = 1 / a[c][c];
    for (std::size_t j = 0; j < n; ++j) {
      a[c][j] *= scale;
      inverse[c][j] *= scale;
    }
    for (std::size_t i = 0; i < n; ++i) {
      if (i == c) continue;
      const Real factor = a[i][c];
      for (std::size_t j = 0; j < n; ++j) {
        a[i][j] -= factor * a[c][j];
        inverse[i][j] -= factor * inverse[c][j];
      }
    }
  }
  return inverse;
}

inline Vector product(const Matrix &a, const Vector &x) {
  Vector y(a.size());
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < x.size(); ++j) y[i] += a[i][j] * x[j];
  return y;
}

inline Real largest(const Vector &x) {
  Real most = 0;
  for (const Real &entry : x) most = std::max<Real>(most, abs(entry));
  return most;
}

/// Moves `x` to a zero of f, until a step is below `tolerance`; returns that step. `inverse`
/// approximates the inverse of the derivatives: differences where it comes empty, then what every
/// step shows (Broyden's update), so that it serves for a neighbouring f as well. Throws
/// std::runtime_error if forty steps do not do.
template <class Function>
Real solve(const Function &f, Vector &x, Matrix &inverse, const Real &tolerance) {
  Vector value = f(x);
  const std::size_t n = x.size();
  if (inverse.empty()) {
    Matrix derivatives(n, Vector(n));
    const Real h = small(20);
    for (std::size_t j = 0; j < n; ++j) {
      Vector beside = x;
      beside[j] += h;
      const Vector there = f(beside);
      for (std::size_t i = 0; i < n; ++i) derivatives[i][j] = (there[i] - value[i]) / h;
    }
    inverse = inverse_of(std::move(derivatives));
  }
  for (int iteration = 0; iteration < 40; ++iteration) {
    Vector step = product(inverse, value);
    for (Real &entry : step) entry = -entry;
    for (std::size_t i = 0; i < n; ++i) x[i] += step[i];
    if (largest(step) <= tolerance) return largest(step);
    const Vector next = f(x);
    Vector change(n);
    for (std::size_t i = 0; i < n; ++i) change[i] = next[i] - value[i];
    value = next;
    // inverse += (step - inverse change) (step^T inverse) / (step^T inverse change).
    const Vector moved = product(inverse, change);
    Vector row(n);
    Real scale = 0;
    for (std::size_t i = 0; i < n; ++i) {
      scale += step[i] * moved[i];
      for (std::size_t j = 0; j < n; ++j) row[j] += step[i] * inverse[i][j];
    }
    if (scale == 0) throw std::runtime_error("solve: a step that changes nothing");
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) inverse[i][j] += (step[i] - moved[i]) * row[j] / scale;
  }
  throw std::runtime_error("solve: no zero after forty steps");
}

}  // namespace vibro_impact_reference
