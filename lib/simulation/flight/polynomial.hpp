// Polynomials in u on [0, 1]: a gap or a hold force along one expansion. Everything is summed in
// packets of four terms c_n u^n, with no chain of dependent operations as long as the polynomial.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <optional>

#include "vibro_impact/counters.hpp"

namespace vibro_impact {

// No expansion goes beyond this order: over the longest span (`max_reach`) 23 lies below rounding.
constexpr int max_order = 27;

// A number for every order, read in packets, also beyond the last.
using Terms = std::array<double, max_order + 8>;

// Four zeros follow the last coefficient (see `end_at`).
struct Polynomial {
  Terms coefficient{};
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

using Packet = Eigen::Array<double, 4, 1>;

// binomial[k][n] = n over k: the derivatives of u^n are binomial[k][n] u^(n - k) k!.
inline const auto binomial = [] {
  std::array<Terms, 6> table{};
  for (std::size_t n = 0; n < table[0].size(); ++n) {
    table[0][n] = 1.0;
    for (std::size_t k = 1; k < table.size() && n > 0; ++k)
      table[k][n] = table[k][n - 1] + table[k - 1][n - 1];
  }
  return table;
}();

inline Packet packet(const double *at) {
  return Eigen::Map<const Packet>(at);
}

// 1, x, x^2, x^3.
inline Packet powers_of(double x) {
  return Packet(1.0, x, x * x, x * x * x);
}

inline Packet binomials(int k, int n) {
  return packet(binomial[static_cast<std::size_t>(k)].data() + n);
}

// The polynomial with its `first` leading coefficients divided out, about u >= 0.
inline Jet jet_at(const Polynomial &p, int first, double u) {
  const double *c = p.coefficient.data() + first;
  const double quartic = u * u * u * u, inverse = 1.0 / std::max(u, 1e-300);
  Packet power = powers_of(u);
  Packet value = Packet::Zero(), slope = value, second = value, third = value, fourth = value;
  for (int n = 0; n <= p.order - first; n += 4) {
    const Packet term = packet(c + n) * power;
    value += term;
    slope += binomials(1, n) * term;
    second += binomials(2, n) * term;
    third += binomials(3, n) * term;
    fourth += binomials(4, n) * term;
    power *= quartic;
  }
  // From left to right, so that what has underflown stays zero.
  return {value.sum(), slope.sum() * inverse, second.sum() * inverse * inverse,
          third.sum() * inverse * inverse * inverse,
          fourth.sum() * inverse * inverse * inverse * inverse};
}

// Upper bound on [0, u] of |p^(k)| / k! of the same. For k = 0 the sum of the moduli of the terms:
// the scale of the rounding of the value at u.
inline double derivative_bound(const Polynomial &p, int first, int k, double u = 1.0) {
  const double *c = p.coefficient.data() + first + k, quartic = u * u * u * u;
  Packet sum = Packet::Zero(), power = powers_of(u);
  for (int n = 0; n <= p.order - first - k; n += 4) {
    sum += binomials(k, n + k) * packet(c + n).abs() * power;
    power *= quartic;
  }
  return sum.sum();
}

struct Root {
  double at = 0.0;     // u
  double slope = 0.0;  // there
};

// First root in (0, limit] of the polynomial with its leading coefficients that are exactly zero
// divided out, with a guarantee and without sampling (lib/README.md); nothing when there is none.
// The first that is not zero should be positive; when it is negative the root returned is 0, with
// the slope there.
std::optional<Root> first_root(const Polynomial &p, double limit, Counters &counters);

}  // namespace vibro_impact
