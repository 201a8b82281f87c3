// Polynomials in u on [0, 1]: a gap or a hold force along one step.
#pragma once

#include <array>
#include <optional>

#include "vibro_impact/counters.hpp"

namespace vibro_impact::detail {

// No step goes beyond this order: over the longest one (`max_step_radians`) 23 lies below rounding.
constexpr int max_order = 27;

// A number for every order, read in packets of four, also beyond the last.
using Terms = std::array<double, max_order + 8>;

// sum of coefficient_n u^n, n = 0, ..., order. Four zeros follow the last coefficient.
struct Polynomial {
  Terms coefficient{};
  int order = 0;
};

// Taylor coefficients of a polynomial about one point: p, p', p''/2, p'''/6, p''''/24.
struct Jet {
  double value, slope, second, third, fourth;
};

// The polynomial with its `first` leading coefficients divided out, about u >= 0.
Jet jet_at(const Polynomial &p, int first, double u);

struct Root {
  double u = 0.0;
  double slope = 0.0;  // there
};

// First root in (0, limit] of the polynomial with its leading coefficients that are exactly zero
// divided out, with a guarantee and without sampling ((8) of lib/README.md); nothing when there is
// none. The first coefficient that is not zero should be positive; when it is negative the root
// returned is 0, with the slope there.
std::optional<Root> first_root(const Polynomial &p, double limit, Counters &counters);

}  // namespace vibro_impact::detail
