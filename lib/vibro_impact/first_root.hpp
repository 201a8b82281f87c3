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
  double slope = 0.0;        // p'(u) of the polynomial searched
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

// An upper bound on [0, reach] of -p'' of the polynomial with its first coefficients divided out.
inline double curvature_bound(const Polynomial &p, int first, double reach) {
  return std::max(0.0, -lower_bound(p, first + 2, [first, reach](int n) {
                    return static_cast<double>(n - first) * static_cast<double>(n - first - 1) *
                           (reach == 1.0 ? 1.0 : std::pow(reach, n - first - 2));
                  }));
}

// The positive root of value + slope d - curvature d^2 / 2 for value > 0, in the form that does not
// cancel: a mass that leaves its stop slowly and is pulled away has slope^2 >> curvature value.
inline double safe_step(double value, double slope, double curvature) {
  const double root = std::sqrt(slope * slope + 2.0 * curvature * value);
  return slope > 0.0 ? (slope + root) / curvature : 2.0 * value / (root - slope);
}

}  // namespace detail

// First root in (0, limit] of the polynomial with its `zeros` leading (exactly zero) coefficients
// divided out; nothing when there is none. A positive leading coefficient is expected; when the
// first non-zero one is negative the root returned is 0. `slope` belongs to the whole polynomial.
inline std::optional<Root> first_root(const Polynomial &p, int zeros, double limit,
                                      Counters &counters) {
  int first = zeros;
  while (first <= p.order && p.coefficient[static_cast<std::size_t>(first)] == 0.0) ++first;
  if (first > p.order) return std::nullopt;  // identically zero: it never leaves, never returns
  const auto at = [&](int n) { return p.coefficient[static_cast<std::size_t>(n)]; };
  if (at(first) < 0.0) return Root{};
  if (detail::lower_bound(p, first, [](int) { return 1.0; }) > 0.0) {
    ++counters.roots_dismissed;
    return std::nullopt;
  }
  ++counters.roots_searched;
  double reach = 1.0, curvature = detail::curvature_bound(p, first, reach);
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  double u = 0.0;
  int steps = 0;
  // Ends: u grows by at least one unit in the last place per step, and quadratically near a
  // transversal root; at an exact tangency the distance falls by a constant factor per step.
  while (true) {
    const auto [value, slope] = detail::value_and_slope(p, first, u);
    double step = value <= 0.0 ? 0.0 : detail::safe_step(value, slope, curvature);
    if (step <= 1e-6 * u) {  // near a root, or at it (or, step = 0 at u = 0, out of range)
      const double noise = epsilon * detail::size_at(p, first, u);
      if (value <= 0.5 * noise || u + step == u) {
        const double whole_slope = first == 0 ? slope : std::pow(u, first) * slope;
        return Root{u, whole_slope, std::min(2.0 * noise / std::max(std::abs(slope), noise), 1e-9)};
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
