#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "polynomial.hpp"
#include "simulation/chain/tolerances.hpp"
#include "vibro_impact/instant.hpp"

namespace vibro_impact::detail {

namespace {

// n! / (5! (n - 5)!)
constexpr auto binomials_of_5 = [] {
  std::array<double, max_order + 1> numbers{};
  for (std::size_t n = 5; n < numbers.size(); ++n) {
    const auto order = static_cast<double>(n);
    numbers[n] = order * (order - 1.0) * (order - 2.0) * (order - 3.0) * (order - 4.0) / 120.0;
  }
  return numbers;
}();

// A bound of |q^(5)| / 5! on [0, u], q(u) = p(u) / u^zeros.
double fifth_bound(const Polynomial &p, int zeros, double u) {
  const double *c = p.coefficient.data() + zeros;
  double sum = 0.0;
  for (int n = p.order - zeros; n >= 5; --n)
    sum = sum * u + binomials_of_5[static_cast<std::size_t>(n)] * std::abs(c[n]);
  return sum;
}

// The sum of the moduli of the terms of q at u.
double sum_of_moduli(const Polynomial &p, int zeros, double u) {
  double sum = 0.0;
  for (int n = p.order; n >= zeros; --n)
    sum = sum * u + std::abs(p.coefficient[static_cast<std::size_t>(n)]);
  return sum;
}

}  // namespace

Jet jet_at(const Polynomial &p, int zeros, double u) {
  Jet jet{};
  for (int n = p.order; n >= zeros; --n) {
    jet.fourth = jet.fourth * u + jet.third;
    jet.third = jet.third * u + jet.second;
    jet.second = jet.second * u + jet.slope;
    jet.slope = jet.slope * u + jet.value;
    jet.value = jet.value * u + p.coefficient[static_cast<std::size_t>(n)];
  }
  return jet;
}

namespace {

// A lower bound over [u, u + h] of the polynomial with this jet at u and |p^(5)| / 5! <= fifth. It
// is the minimum of a parabola below the polynomial, with the least second coefficient that the
// higher terms allow.
inline double lower_bound(const Jet &jet, double fifth, double h) {
  const double third = jet.third + h * std::min(0.0, jet.fourth - h * fifth),
               second = jet.second + h * std::min(0.0, third);
  const double lowest = second > 0.0 ? std::clamp(-0.5 * jet.slope / second, 0.0, h) : h;
  return jet.value + std::min(0.0, lowest * (jet.slope + lowest * second));
}

// An upper bound of |p''| over [u - h, u + h].
inline double curvature_bound(const Jet &jet, double fifth, double h) {
  const double third =
      3.0 * std::abs(jet.third) + h * (6.0 * std::abs(jet.fourth) + h * 10.0 * fifth);
  return 2.0 * (std::abs(jet.second) + h * third);
}

// Newton's step, corrected to fourth order by the inverse of the series of q about its point.
// `curvature` bounds |q'' newton / q'|: the root lies within curvature * |newton| of Newton's step.
inline double corrected(double newton, const Jet &jet, double curvature) {
  // The reciprocal of a slope and squares of these quotients may leave the range of double
  // precision.
  const double a = jet.second / -jet.slope * newton, b = jet.third / -jet.slope * newton * newton,
               c = jet.fourth / -jet.slope * newton * newton * newton;
  const double correction = a + (2.0 * a * a + b) + (5.0 * (a * a + b) * a + c);
  return newton * (1.0 + std::clamp(correction, -curvature, curvature));
}

// The root near u, where the slope of q(u) = p(u) / u^zeros hardly varies.
std::optional<double> polished(const Polynomial &p, int zeros, double u, const Jet &jet,
                               double newton, double curvature, double u_max) {
  double v = u + corrected(newton, jet, curvature), change = infinity;
  for (int k = 0; k < most_newton_steps && std::abs(change) > newton_accuracy * std::abs(v - u);
       ++k) {
    const Jet near = jet_at(p, zeros, v);
    change = corrected(-near.value / near.slope, near, curvature);
    v += change;
  }
  if (v > u_max) return std::nullopt;
  // The square has underflown and lost digits, and the polynomial is no line.
  if (v * v < std::numeric_limits<double>::min() && curvature > polynomial_rounding)
    return std::numeric_limits<double>::quiet_NaN();
  return std::max(v, 0.0);  // or not a number
}

// The length of the longest stretch from u on, up to u_max, on which the lower bound (5) of the
// polynomial exceeds its rounding: the whole, or a half of it, a quarter and so on. It is 0 if that
// is too short to move u.
double positive_stretch(const Polynomial &p, int zeros, double u, double u_max, const Jet &jet,
                        double fifth, double rounding) {
  for (double stretch = u_max - u; u + stretch > u; stretch *= 0.5) {
    const double end = u + stretch;
    // The bound of p^(5) over the whole step is far too large for a small polynomial near 0.
    const double fifth_to_end = end < 0.25 ? fifth_bound(p, zeros, end) : fifth;
    if (lower_bound(jet, fifth_to_end, stretch) > rounding) return stretch;
  }
  return 0.0;
}

}  // namespace

std::optional<double> first_root(const Polynomial &p, double u_max, Counters &counters,
                                 int most_iterations) {
  int zeros = 0;
  while (zeros <= p.order && p.coefficient[static_cast<std::size_t>(zeros)] == 0.0) ++zeros;
  if (zeros > p.order) return std::nullopt;  // identically zero
  const double *c = p.coefficient.data() + zeros;
  if (c[0] < 0.0) return 0.0;
  Jet jet{c[0], c[1], c[2], c[3], c[4]};  // coefficients beyond the order are zero
  const double fifth = fifth_bound(p, zeros, u_max);
  if (lower_bound(jet, fifth, u_max) > 0.0) return std::nullopt;
  const double sum = jet.value + jet.slope + jet.second + jet.third + jet.fourth + fifth;
  if (!std::isfinite(sum)) return std::numeric_limits<double>::quiet_NaN();
  ++counters.roots_searched;
  double u = 0.0;
  // Away from roots u grows, unless a power of u leaves the range of double precision.
  for (int iteration = 0; iteration < most_iterations; ++iteration) {
    ++counters.root_iterations;
    // Kantorovich's condition with a margin of two: p' varies by less than half of itself over
    // twice Newton's step, so that this interval has exactly one root, as far as it lies in the
    // step. A root beyond the step is none.
    const double newton = -jet.value / jet.slope, distance = std::abs(newton);
    const double curvature = curvature_bound(jet, fifth, 2.0 * distance) * distance / -jet.slope;
    if (jet.slope < 0.0 && curvature <= 0.25)
      return polished(p, zeros, u, jet, newton, curvature, u_max);
    const double rounding =
        polynomial_rounding * (u > 0.0 ? sum_of_moduli(p, zeros, u) : jet.value);
    // From more than twice the rounding a step goes a share of the way to a tangency. With less the
    // steps would become ever shorter.
    if (!(jet.value > 2.0 * rounding)) return u;
    const double stretch = positive_stretch(p, zeros, u, u_max, jet, fifth, rounding);
    if (stretch == 0.0) return u;
    u += stretch;
    if (!(u < u_max)) return std::nullopt;
    jet = jet_at(p, zeros, u);
  }
  return infinity;
}

}  // namespace vibro_impact::detail
