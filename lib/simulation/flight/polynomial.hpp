// Polynomials in u on [0, 1]: a gap or a hold force along one step, or its bound in a long flight.
#pragma once

#include <array>
#include <optional>

#include "simulation/chain/tolerances.hpp"
#include "vibro_impact/counters.hpp"

namespace vibro_impact::detail {

// The largest order of a step, for the least `flight_tolerance` and for gaps with many zeros.
constexpr int max_order = 27;

// One number for each order, and four beyond the last.
using Terms = std::array<double, max_order + 5>;

// p(u) = sum of coefficient_n u^n, n = 0, ..., order. Four zeros follow the last coefficient.
struct Polynomial {
  Terms coefficient{};
  int order = 0;
};

// The Taylor coefficients p, p', p''/2, p'''/6, p''''/24 of a polynomial about one point.
struct Jet {
  double value, slope, second, third, fourth;
};

// The jet about u of p(u) / u^zeros, whose first `zeros` coefficients are zero.
Jet jet_at(const Polynomial &p, int zeros, double u);

// The first root in (0, u_max] of p(u) / u^zeros, where `zeros` is the number of leading
// coefficients that are exactly zero. The search is guaranteed to miss no root and takes no
// samples: (5) of lib/README.md. If the first non-zero coefficient is negative, the root is
// 0. A point where p lies within its rounding is a root, too. If powers of u leave the range of
// double precision, it is NaN. If the search does not end within its iterations, it is infinite.
std::optional<double> first_root(const Polynomial &p, double u_max, Counters &counters,
                                 int most_iterations = most_root_iterations);

}  // namespace vibro_impact::detail
