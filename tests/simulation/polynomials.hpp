// Polynomials from coefficients in extended precision, and their values there.
#pragma once

#include <cmath>
#include <vector>

#include "simulation/flight/polynomial.hpp"

namespace vibro_impact::testing {

using Coefficients = std::vector<long double>;

inline Polynomial rounded(const Coefficients &coefficients) {
  Polynomial p;
  p.coefficient.fill(NAN);  // what lies beyond the padding must not be read
  end_at(p, static_cast<int>(coefficients.size()) - 1);
  for (std::size_t n = 0; n < coefficients.size(); ++n)
    p.coefficient[n] = static_cast<double>(coefficients[n]);
  return p;
}

inline Coefficients times(const Coefficients &a, const Coefficients &b) {
  Coefficients product(a.size() + b.size() - 1, 0.0L);
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j) product[i + j] += a[i] * b[j];
  return product;
}

inline long double value_of(const Polynomial &p, long double u) {
  long double value = 0.0L;
  for (int n = p.order; n >= 0; --n) value = value * u + p.coefficient[static_cast<std::size_t>(n)];
  return value;
}

inline long double slope_of(const Polynomial &p, long double u) {
  long double slope = 0.0L;
  for (int n = p.order; n >= 1; --n)
    slope = slope * u + n * static_cast<long double>(p.coefficient[static_cast<std::size_t>(n)]);
  return slope;
}

// Sum of the moduli of the terms: the scale of the rounding of a value of p.
inline double size_of(const Polynomial &p, double u) {
  double size = 0.0;
  for (int n = p.order; n >= 0; --n)
    size = size * u + std::abs(p.coefficient[static_cast<std::size_t>(n)]);
  return size;
}

}  // namespace vibro_impact::testing
