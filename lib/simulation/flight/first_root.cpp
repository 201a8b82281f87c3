#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>

#include "polynomial.hpp"

namespace vibro_impact::detail {

namespace {

// Sums run over packets of four terms c_n u^n, with no chain of dependent operations as long as the
// polynomial.
using Packet = Eigen::Array<double, 4, 1>;

// binomial[k][n] = n over k: the derivatives of u^n are binomial[k][n] u^(n - k) k!.
const auto binomial = [] {
  std::array<Terms, 6> table{};
  for (std::size_t n = 0; n < table[0].size(); ++n) {
    table[0][n] = 1.0;
    for (std::size_t k = 1; k < table.size() && n > 0; ++k)
      table[k][n] = table[k][n - 1] + table[k - 1][n - 1];
  }
  return table;
}();

Packet packet(const double *first) {
  return Eigen::Map<const Packet>(first);
}

// 1, x, x^2, x^3.
Packet powers_of(double x) {
  return Packet(1.0, x, x * x, x * x * x);
}

Packet binomials(int k, int n) {
  return packet(binomial[static_cast<std::size_t>(k)].data() + n);
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

// A lower bound, over the next h, of the polynomial with this jet, |p^(5)| / 5! being at most
// `fifth` there: the least value of the lowest parabola that the higher terms can make of it.
inline double lower_bound(const Jet &jet, double fifth, double h) {
  const double third = jet.third + h * std::min(0.0, jet.fourth - h * fifth),
               second = jet.second + h * std::min(0.0, third);
  const double lowest = second > 0.0 ? std::clamp(-0.5 * jet.slope / second, 0.0, h) : h;
  return jet.value + std::min(0.0, lowest * (jet.slope + lowest * second));
}

// An upper bound of |p''| over the next h and the h before.
inline double curvature_bound(const Jet &jet, double fifth, double h) {
  const double third =
      3.0 * std::abs(jet.third) + h * (6.0 * std::abs(jet.fourth) + h * 10.0 * fifth);
  return 2.0 * (std::abs(jet.second) + h * third);
}

// A root at u of the polynomial with its first coefficients divided out, where it has this slope.
Root root_at(double u, double slope, int first) {
  for (int k = 0; k < first; ++k) slope *= u;
  return {u, slope};
}

// A step towards the root of a jet by the inverse of its series, to fourth order in Newton's step.
struct SeriesStep {
  double step;
  double slope;  // after the step, relative to the slope before it
  double error;  // of that slope, relative; that of the step, relative, is less
};

// `bent` bounds |p''| newton / |p'|: the step is kept within the distance from Newton's at which
// the root can lie.
inline SeriesStep series_step(const Jet &jet, double newton, double bent, double fifth) {
  const double inverse = -1.0 / jet.slope;
  const double a = jet.second * inverse, b = jet.third * inverse, c = jet.fourth * inverse;
  const double aa = a * a, n2 = newton * newton;
  double correction = newton * (a + newton * (2.0 * aa + b + newton * (5.0 * (aa + b) * a + c)));
  if (std::abs(correction) > bent) [[unlikely]]
    correction = std::copysign(bent, correction);
  const double step = newton + newton * correction;
  const double next = 14.0 * aa * aa + 21.0 * aa * std::abs(b) + 6.0 * std::abs(a * c) +
                      3.0 * b * b + fifth * std::abs(inverse);
  return {step, 1.0 - step * (2.0 * a + step * (3.0 * b + step * (4.0 * c))), 5.0 * next * n2 * n2};
}

}  // namespace

Jet jet_at(const Polynomial &p, int first, double u) {
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

std::optional<Root> first_root(const Polynomial &p, double limit, Counters &counters) {
  int first = 0;
  while (first <= p.order && p.coefficient[static_cast<std::size_t>(first)] == 0.0) ++first;
  if (first > p.order) return std::nullopt;  // identically zero: it never leaves, never returns
  const double *c = p.coefficient.data() + first;
  if (c[0] < 0.0) return Root{0.0, first == 0 ? c[1] : first == 1 ? c[0] : 0.0};
  Jet jet{c[0], c[1], c[2], c[3], c[4]};  // zero beyond the order
  const double fifth = derivative_bound(p, first, 5);
  if (lower_bound(jet, fifth, limit) > 0.0) {
    ++counters.roots_dismissed;
    return std::nullopt;
  }
  const double sum = jet.value + jet.slope + jet.second + jet.third + jet.fourth + fifth;
  if (!std::isfinite(sum)) return std::nullopt;  // the run will be given up
  ++counters.roots_searched;
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  double u = 0.0, last_newton = std::numeric_limits<double>::infinity();
  // Ends: Newton's step is at least halved near a root; away from one u grows.
  while (true) {
    // Kantorovich, with a margin of two: p' varies by less than half of itself over twice Newton's
    // step, so that the root ahead is the only one there.
    const double newton = -jet.value / jet.slope, distance = std::abs(newton);
    const double bent = curvature_bound(jet, fifth, 2.0 * distance) * distance / -jet.slope;
    if (jet.slope < 0.0 && bent <= 0.25) {
      const SeriesStep next = series_step(jet, newton, bent, fifth);
      const bool stalled =  // by rounding
          !(distance < 0.5 * last_newton) &&
          std::abs(jet.value) <= 32.0 * epsilon * derivative_bound(p, first, 0, u);
      if (next.error <= 0.25 * epsilon || stalled) {
        if (!(u + next.step <= limit)) return std::nullopt;
        return root_at(u + next.step, jet.slope * next.slope, first);
      }
      if (u + next.step <= limit) {
        ++counters.root_iterations;
        last_newton = distance;
        u += next.step;
        jet = jet_at(p, first, u);
        continue;
      }
    }
    // Else over a stretch that is clear of zero, by more than the rounding of the value here. (The
    // bound of p^(5) up to 1 is far too large for a small polynomial near 0: one up to there.)
    const double rounded = 0.5 * epsilon * derivative_bound(p, first, 0, u);
    double stretch = limit - u;
    const auto is_clear = [&] {
      const double end = u + stretch;
      const double near = end < 0.25 ? derivative_bound(p, first, 5, end) : fifth;
      return lower_bound(jet, near, stretch) > rounded;
    };
    while (u + stretch > u && !is_clear()) stretch *= 0.5;
    if (!(u + stretch > u)) return root_at(u, jet.slope, first);
    ++counters.root_iterations;
    u += stretch;
    if (!(u < limit)) return std::nullopt;
    jet = jet_at(p, first, u);
  }
}

}  // namespace vibro_impact::detail
