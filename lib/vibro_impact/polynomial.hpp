// Polynomials in u on [0, 1]: the gap of a stop, or a hold force, along one expansion.
//
// Everything is summed in packets of four terms c_n u^n, with no chain of dependent operations as
// long as the polynomial: a value and its first four derivatives cost little more than a value.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>

#include "flow.hpp"

namespace vibro_impact {

constexpr int max_order = 32;

// Coefficients are read in packets, also beyond the order: four zeros follow the last one (see
// `end_at`).
struct Polynomial {
  std::array<double, max_order + 8> coefficient{};
  int order = 0;
};

inline void end_at(Polynomial &p, int order) {
  p.order = order;
  std::fill_n(p.coefficient.begin() + order + 1, 4, 0.0);
}

// Taylor coefficients of a polynomial about one point: p, p', p''/2, p'''/6, p''''/24.
struct Jet {
  double value, slope, second, third, fourth;
};

namespace detail {

using Two = Eigen::Array<double, 2, 1>;
using Four = Eigen::Array<double, 4, 1>;

// binomial[k][n] = n over k: the derivatives of u^n are binomial[k][n] u^(n - k) k!.
inline const auto binomial = [] {
  std::array<std::array<double, max_order + 8>, 6> table{};
  for (std::size_t n = 0; n < table[0].size(); ++n) {
    table[0][n] = 1.0;
    for (std::size_t k = 1; k < table.size() && n > 0; ++k)
      table[k][n] = table[k][n - 1] + table[k - 1][n - 1];
  }
  return table;
}();

inline Two two(const double *at) {
  return Eigen::Map<const Two>(at);
}

// 1, x: without a detour through memory.
inline Two one_and(double x) {
  static constexpr std::array<double, 4> units{1.0, 0.0, 0.0, 1.0};
  return two(units.data()) + x * two(units.data() + 2);
}

inline Four four(const double *at) {
  return Eigen::Map<const Four>(at);
}

// 1, x, x^2, x^3.
inline Four four_powers(double x) {
  Four powers;
  powers.head<2>() = one_and(x);
  powers.tail<2>() = one_and(x) * (x * x);
  return powers;
}

inline Four four_binomials(std::size_t k, int n) {
  return four(binomial[k].data() + n);
}

using Powers = std::array<double, max_order + 8>;

// 1, x, x^2, ... in whole packets of four.
inline void set_powers(Powers &powers, double x, int order) {
  const double quartic = x * x * x * x;
  Four power = four_powers(x);
  for (int n = 0; n <= order; n += 4) {
    Eigen::Map<Four>(powers.data() + n) = power;
    power *= quartic;
  }
}

// Sums over the coefficients: bounds on [0, 1].
struct Bounds {
  double end;        // value at 1
  double lowest;     // lower bound of the value, for c_0 > 0: c_0 and all negative ones
  double bend;       // |p''|
  double curvature;  // -p''
  double fifth;      // |p^(5)| / 5!
};

// Negative terms are summed by themselves: as a difference of all terms and their moduli they would
// be lost in the rounding of larger ones.
inline Bounds bounds_of(const Polynomial &p, int first) {
  const double *c = p.coefficient.data() + first;
  Four sum = Four::Zero(), negative = sum, bend = sum, down = sum, fifth = sum;
  for (int n = 0; n <= p.order - first; n += 4) {
    const Four at = four(c + n), curved = four_binomials(2, n) * at;
    sum += at;
    negative += at.min(0.0);
    bend += curved.abs();
    down += curved.min(0.0);
    fifth += four_binomials(5, n) * at.abs();
  }
  return {sum.sum(), c[0] + negative.sum(), 2.0 * bend.sum(), std::max(0.0, -2.0 * down.sum()),
          fifth.sum()};
}

// An upper bound on [0, 1] of |p'''|.
inline double twist_bound(const Polynomial &p, int first) {
  const double *c = p.coefficient.data() + first;
  Four sum = Four::Zero();
  for (int n = 0; n <= p.order - first; n += 4) sum += four_binomials(3, n) * four(c + n).abs();
  return 6.0 * sum.sum();
}

// Lower bound on [0, 1] of sum_{n >= first} weight(n) c_n u^(n - first): nested minima.
template <class Weight>
double lower_bound(const Polynomial &p, int first, Weight weight) {
  double bound = 0.0;
  for (int n = p.order; n >= first; --n)
    bound = weight(n) * p.coefficient[static_cast<std::size_t>(n)] + std::min(0.0, bound);
  return bound;
}

}  // namespace detail

// The polynomial with its `first` leading coefficients divided out, about u >= 0.
inline Jet jet_at(const Polynomial &p, int first, double u) {
  using detail::Four;
  const double *c = p.coefficient.data() + first;
  const double quartic = u * u * u * u, inverse = 1.0 / std::max(u, 1e-300);
  Four power = detail::four_powers(u);
  Four value = Four::Zero(), slope = value, second = value, third = value, fourth = value;
  for (int n = 0; n <= p.order - first; n += 4) {
    const Four term = detail::four(c + n) * power;
    value += term;
    slope += detail::four_binomials(1, n) * term;
    second += detail::four_binomials(2, n) * term;
    third += detail::four_binomials(3, n) * term;
    fourth += detail::four_binomials(4, n) * term;
    power *= quartic;
  }
  // From left to right, so that what has underflown stays zero.
  return {value.sum(), slope.sum() * inverse, second.sum() * inverse * inverse,
          third.sum() * inverse * inverse * inverse,
          fourth.sum() * inverse * inverse * inverse * inverse};
}

// Sum of the moduli of the terms at u: the scale of the rounding of the value there.
inline double size_at(const Polynomial &p, int first, double u) {
  using detail::Four;
  const double *c = p.coefficient.data() + first, quartic = u * u * u * u;
  Four size = Four::Zero(), power = detail::four_powers(u);
  for (int n = 0; n <= p.order - first; n += 4) {
    size += detail::four(c + n).abs() * power;
    power *= quartic;
  }
  return size.sum();
}

// Value and slope at u, with the exact zeros divided out so that small values keep their accuracy.
inline OscillatorState<double> evaluate(const Polynomial &p, int zeros, double u) {
  using detail::Four;
  const double *c = p.coefficient.data() + zeros, quartic = u * u * u * u;
  Four power = detail::four_powers(u), value_terms = Four::Zero(), slope_terms = value_terms;
  for (int n = 0; n <= p.order - zeros; n += 4) {
    value_terms += detail::four(c + n) * power;
    slope_terms += detail::four(c + n + 1) * detail::four_binomials(1, n + 1) * power;
    power *= quartic;
  }
  double value = value_terms.sum(), slope = slope_terms.sum();
  for (int k = 0; k < zeros; ++k) {
    slope = slope * u + value;
    value *= u;
  }
  return {value, slope};
}

}  // namespace vibro_impact
