// The first root of a polynomial on (0, 1], with a guarantee and without sampling.
//
// From u with p(u) > 0, slope p'(u) and a lower bound -B of p'' on [0, 1], no root lies before the
// positive root of p + p' d - B d^2 / 2. Advancing by that d never passes a root, converges
// quadratically to a transversal one, and passes a dip that does not touch zero: grazing is decided
// instead of sampled for.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "counters.hpp"
#include "expansion.hpp"

namespace vibro_impact {

struct Root {
  double at = 0.0;           // u
  double uncertainty = 0.0;  // of u, from the rounding of the coefficients
};

namespace detail {

// Lower bound on [0, 1] of sum_{n >= first} weight(n) c_n u^(n - first): nested minima.
template <class Weight>
double lower_bound(const Polynomial &p, int first, Weight weight) {
  double bound = 0.0;
  for (int n = p.order; n >= first; --n)
    bound = weight(n) * p.coefficient[static_cast<std::size_t>(n)] + std::min(0.0, bound);
  return bound;
}

// Value and slope at u of sum_{n >= first} c_n u^(n - first). Horner's rule on the even and the odd
// part at once: two short chains of dependent operations instead of a long one.
inline OscillatorState<double> value_and_slope(const Polynomial &p, int first, double u) {
  const auto at = [&](int n) { return p.coefficient[static_cast<std::size_t>(n)]; };
  const double w = u * u;
  double even = 0.0, even_slope = 0.0, odd = 0.0, odd_slope = 0.0;  // slopes with respect to w
  int n = p.order;
  if ((n - first) % 2 == 0) even = at(n--);
  for (; n > first; n -= 2) {
    odd_slope = odd_slope * w + odd;
    even_slope = even_slope * w + even;
    odd = odd * w + at(n);
    even = even * w + at(n - 1);
  }
  return {even + u * odd, odd + 2.0 * u * (even_slope + u * odd_slope)};
}

// Sum of the moduli of the terms at u: the scale of the rounding of the value.
inline double size_at(const Polynomial &p, int first, double u) {
  double size = 0.0;
  for (int n = p.order; n >= first; --n)
    size = size * u + std::abs(p.coefficient[static_cast<std::size_t>(n)]);
  return size;
}

// The coefficients from `first` on, for sums over them.
inline auto coefficients_from(const Polynomial &p, int first) {
  return Eigen::Map<const Eigen::ArrayXd>(p.coefficient.data() + first,
                                          std::max(0, p.order - first + 1));
}

// An upper bound on [0, reach] of -p'' of the polynomial with its first coefficients divided out.
inline double curvature_bound(const Polynomial &p, int first, double reach) {
  const auto second = [first](int n) {
    return static_cast<double>(n - first) * static_cast<double>(n - first - 1);
  };
  if (reach == 1.0) return std::max(0.0, -lower_bound(p, first + 2, second));
  const auto within = [&](int n) { return second(n) * std::pow(reach, n - first - 2); };
  return std::max(0.0, -lower_bound(p, first + 2, within));
}

// An upper bound on [0, 1] of |p''| of the same.
inline double bend_bound(const Polynomial &p, int first) {
  static const Eigen::ArrayXd weight = [] {
    Eigen::ArrayXd n = Eigen::ArrayXd::LinSpaced(max_order + 1, 2.0, max_order + 2.0);
    return Eigen::ArrayXd(n * (n - 1.0));
  }();
  const auto rest = coefficients_from(p, first + 2);
  return (rest.abs() * weight.head(rest.size())).sum();
}

// The positive root of value + slope d - curvature d^2 / 2 for value > 0, in the form that does not
// cancel: a mass that leaves its stop slowly and is pulled away has slope^2 >> curvature value.
// Near a transversal root a little less, without the square root: sqrt(1 + x) < 1 + x / 2.
inline double safe_step(double value, double slope, double curvature) {
  const double square = slope * slope, bent = curvature * value;
  if (slope < 0.0 && bent < 0x1p-6 * square) return -value * slope / (square + 0.5 * bent);
  const double root = std::sqrt(square + 2.0 * bent);
  return slope > 0.0 ? (slope + root) / curvature : 2.0 * value / (root - slope);
}

}  // namespace detail

// First root in (0, limit] of the polynomial with its `zeros` leading (exactly zero) coefficients
// divided out; nothing when there is none. A positive leading coefficient is expected; when the
// first non-zero one is negative the root returned is 0.
inline std::optional<Root> first_root(const Polynomial &p, int zeros, double limit,
                                      Counters &counters) {
  int first = zeros;
  while (first <= p.order && p.coefficient[static_cast<std::size_t>(first)] == 0.0) ++first;
  if (first > p.order) return std::nullopt;  // identically zero: it never leaves, never returns
  const auto at = [&](int n) { return p.coefficient[static_cast<std::size_t>(n)]; };
  if (at(first) < 0.0) return Root{};
  // Most stops are dismissed by the sum of the negative coefficients, the others by nested minima,
  // which are tighter; a polynomial that ends below zero needs neither.
  const auto rest = detail::coefficients_from(p, first + 1);
  if (at(first) + rest.min(0.0).sum() > 0.0 ||
      (at(first) + rest.sum() > 0.0 &&
       detail::lower_bound(p, first, [](int) { return 1.0; }) > 0.0)) {
    ++counters.roots_dismissed;
    return std::nullopt;
  }
  ++counters.roots_searched;
  double reach = 1.0, curvature = detail::curvature_bound(p, first, reach);
  const double bend = detail::bend_bound(p, first);
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  double u = 0.0, value = at(first), slope = first < p.order ? at(first + 1) : 0.0;
  int steps = 0;
  // Ends: u grows by at least one unit in the last place per step, and quadratically near a
  // transversal root; at an exact tangency the distance falls by a constant factor per step.
  while (true) {
    double step = value <= 0.0 ? 0.0 : detail::safe_step(value, slope, curvature);
    // Kantorovich: where bend step <= |p'| / 8 the root is that near, and what the step leaves of
    // the distance to it is below bend step^2 / |p'|.
    const bool last =
        bend * step <= -0.125 * slope && bend * step * step <= -0.25 * epsilon * u * slope;
    if (last || step <= 1e-6 * u) {  // or near a root (or, step = 0 at u = 0, out of range)
      const double noise = epsilon * detail::size_at(p, first, u);
      if (last || value <= 0.5 * noise || u + step == u) {
        if (last) u += step;
        if (!(u <= limit)) return std::nullopt;
        return Root{u, std::min(2.0 * noise / std::max(std::abs(slope), noise), 1e-9)};
      }
    }
    ++counters.root_iterations;
    if (reach < 1.0 && u + step > reach) {  // not beyond where the bound holds
      step = reach - u;
      reach = std::min(1.0, 4.0 * reach);
      curvature = detail::curvature_bound(p, first, reach);
    } else if (++steps % 32 == 0 && u < 0.25 * reach) {
      // Creeping: the bound over [0, 1] says nothing of a small polynomial near 0.
      reach = std::min(1.0, 4.0 * (u + step));
      curvature = detail::curvature_bound(p, first, reach);
    }
    if (!(u + step <= limit)) return std::nullopt;  // also when the step is infinite
    u += step;
    const auto [value_at, slope_at] = detail::value_and_slope(p, first, u);
    value = value_at;
    slope = slope_at;
  }
}

// Value and slope at u, with the exact zeros divided out so that small values keep their accuracy.
inline OscillatorState<double> evaluate(const Polynomial &p, int zeros, double u) {
  auto [value, slope] = detail::value_and_slope(p, zeros, u);
  for (int k = 0; k < zeros; ++k) {
    slope = slope * u + value;
    value *= u;
  }
  return {value, slope};
}

}  // namespace vibro_impact
