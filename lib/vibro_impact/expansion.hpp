// Taylor expansion of the flow about an event.
//
// The Taylor coefficients of every lane follow from y'' = -kappa y' - lambda y by a two-term
// recurrence, at constant cost per order, and are exact up to a bounded remainder. The variable is
// scaled, u = tau / span in [0, 1]. `order_for` picks the order from fastest * span so that the
// remainder lies below rounding even relative to the second-order term, which is what keeps the
// tiny gaps of a late chatter accurate.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>

#include "counters.hpp"
#include "motion.hpp"

namespace vibro_impact {

constexpr int max_order = 32;
// Largest fastest * span of one expansion. Rounding grows like exp(reach), cost like 1 / reach.
constexpr double max_reach = 2.5;

// A polynomial in u on [0, 1]; entries beyond `order` are not read.
struct Polynomial {
  std::array<double, max_order + 1> coefficient;
  int order = 0;
};

namespace detail {

// reach_of_order[p]: the largest x with 2 x^(p-1) / (p+1)! <= 2^-56, the first term dropped
// relative to the second-order one, x^2 / 2.
inline const std::array<double, max_order + 1> reach_of_order = [] {
  std::array<double, max_order + 1> reach{};
  double factorial = 6.0;  // (p + 1)!
  for (int p = 2; p <= max_order; ++p) {
    reach[static_cast<std::size_t>(p)] = std::pow(0x1p-57 * factorial, 1.0 / (p - 1));
    factorial *= p + 2;
  }
  return reach;
}();

// 1 / (n + 2) and 1 / ((n + 1) (n + 2)), the factors of the recurrence.
inline const std::array<std::array<double, 2>, max_order + 1> recurrence_factor = [] {
  std::array<std::array<double, 2>, max_order + 1> factor{};
  for (int n = 0; n <= max_order; ++n)
    factor[static_cast<std::size_t>(n)] = {1.0 / (n + 2), 1.0 / ((n + 1.0) * (n + 2.0))};
  return factor;
}();

}  // namespace detail

// Smallest order whose remainder lies below rounding over fastest * span = reach.
inline int order_for(double reach) {
  int order = 3;
  while (order < max_order - 1 && detail::reach_of_order[static_cast<std::size_t>(order)] < reach)
    ++order;
  return order;
}

template <int D>
struct Expansion {
  double span = 0.0;
  int order = 0;
  Eigen::Array<double, D, max_order + 2> coefficient;  // column n: u^n, of every lane
};

// Expands the lanes of `mode` about (value, slope) over [0, span].
template <int D>
void expand(const ContactMode<D> &mode, const Eigen::Array<double, D, 1> &value,
            const Eigen::Array<double, D, 1> &slope, double span, Expansion<D> &expansion,
            Counters &counters) {
  const double reach = fastest_in_motion(mode, value, slope) * span;
  expansion.span = span;
  expansion.order = order_for(reach);
  auto &c = expansion.coefficient;
  if constexpr (D == Eigen::Dynamic) {
    if (c.rows() != mode.lanes()) c.resize(mode.lanes(), max_order + 2);
  }
  c.col(0) = value;
  c.col(1) = slope * span;
  const Eigen::Array<double, D, 1> damping = mode.kappa * span,
                                   stiffness = mode.lambda * (span * span);
  for (int n = 0; n + 2 <= expansion.order + 1; ++n) {
    const auto [first, second] = detail::recurrence_factor[static_cast<std::size_t>(n)];
    c.col(n + 2) = -first * (damping * c.col(n + 1)) - second * (stiffness * c.col(n));
    if (mode.any_resonant)
      c.col(n + 2) += (second * span * span * c(mode.lanes() - 2, n)) * mode.resonant;
  }
  ++counters.expansions;
  counters.coefficients += expansion.order + 1;
}

// The lanes at u by Horner's rule.
template <int D>
void advance(const Expansion<D> &expansion, double u, Eigen::Array<double, D, 1> &value,
             Eigen::Array<double, D, 1> &slope) {
  const auto &c = expansion.coefficient;
  value = c.col(expansion.order);
  slope.setZero(value.size());
  for (int n = expansion.order - 1; n >= 0; --n) {
    slope = slope * u + value;
    value = value * u + c.col(n);
  }
  slope /= expansion.span;
}

// The polynomial of a reading along the expansion.
template <int D>
Polynomial polynomial_of(const Reading<D> &reading, const Expansion<D> &expansion,
                         bool with_slope) {
  Polynomial p;
  p.order = expansion.order;
  for (int n = 0; n <= p.order; ++n) {
    p.coefficient[static_cast<std::size_t>(n)] =
        (reading.on_value * expansion.coefficient.col(n)).sum();
    if (with_slope)
      p.coefficient[static_cast<std::size_t>(n)] +=
          (n + 1) / expansion.span * (reading.on_slope * expansion.coefficient.col(n + 1)).sum();
  }
  p.coefficient[0] += reading.offset;
  return p;
}

}  // namespace vibro_impact
