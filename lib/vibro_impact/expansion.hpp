// Taylor expansion of the flow about an event.
//
// The derivatives of every lane follow from y'' = -kappa y' - lambda y by a two-term recurrence, at
// constant cost per order, and are exact up to a bounded remainder. The variable is scaled, u = tau
// / span in [0, 1]. `order_for` picks the order from fastest * span so that the remainder lies
// below rounding even relative to the second-order term, which is what keeps the tiny gaps of a
// late chatter accurate.
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

inline const std::array<double, max_order + 2> inverse_factorial = [] {
  std::array<double, max_order + 2> inverse{};
  double factorial = 1.0;
  for (int n = 0; n < max_order + 2; ++n) {
    inverse[static_cast<std::size_t>(n)] = 1.0 / factorial;
    factorial *= n + 1;
  }
  return inverse;
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
  std::array<Eigen::Array<double, D, 1>, 5> scratch;   // of `expand`, for a dynamic D
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
  // The derivatives with respect to u, y'' = -damping y' - stiffness y, divided by n! on the way
  // out: the division is not in the chain from one order to the next.
  const auto recur = [&](auto &damping, auto &stiffness, auto &before, auto &derivative,
                         auto &next) {
    damping = mode.kappa * -span;
    stiffness = mode.lambda * (span * span);
    c.col(0) = before = value;
    c.col(1) = derivative = slope * span;
    for (int n = 2; n <= expansion.order + 1; ++n) {
      next = damping * derivative - stiffness * before;
      if (mode.any_resonant) next += (span * span * before(mode.lanes() - 2)) * mode.resonant;
      c.col(n) = detail::inverse_factorial[static_cast<std::size_t>(n)] * next;
      before.swap(derivative);
      derivative.swap(next);
    }
  };
  if constexpr (D == Eigen::Dynamic) {  // in storage that is there already
    auto &scratch = expansion.scratch;
    recur(scratch[0], scratch[1], scratch[2], scratch[3], scratch[4]);
  } else {  // in registers
    Eigen::Array<double, D, 1> damping, stiffness, before, derivative, next;
    recur(damping, stiffness, before, derivative, next);
  }
  ++counters.expansions;
  counters.coefficients += expansion.order + 1;
}

// The lanes at u by Horner's rule, on the even and the odd orders at once: the chain of dependent
// operations is half as long.
template <int D>
void advance(const Expansion<D> &expansion, double u, Eigen::Array<double, D, 1> &value,
             Eigen::Array<double, D, 1> &slope) {
  using Lanes = Eigen::Array<double, D, 1>;
  const auto &c = expansion.coefficient;
  const double w = u * u;
  int n = expansion.order;
  const Lanes none = Lanes::Zero(value.size());
  Lanes even = none, odd = none, even_slope = none, odd_slope = none;  // slopes in w
  if (n % 2 == 0) even = c.col(n--);
  for (; n > 0; n -= 2) {
    odd_slope = odd_slope * w + odd;
    even_slope = even_slope * w + even;
    odd = odd * w + c.col(n);
    even = even * w + c.col(n - 1);
  }
  value = even + u * odd;
  slope = (odd + (2.0 * u) * (even_slope + u * odd_slope)) / expansion.span;
}

// Sets `p` to the polynomial of a reading along the expansion.
template <int D>
void read_along(const Reading<D> &reading, const Expansion<D> &expansion, bool with_slope,
                Polynomial &p) {
  p.order = expansion.order;
  for (int n = 0; n <= p.order; ++n) {
    double c = (reading.on_value * expansion.coefficient.col(n)).sum();
    if (with_slope)
      c += (n + 1) / expansion.span * (reading.on_slope * expansion.coefficient.col(n + 1)).sum();
    p.coefficient[static_cast<std::size_t>(n)] = c;
  }
  p.coefficient[0] += reading.offset;
}

}  // namespace vibro_impact
