#include <algorithm>
#include <cmath>
#include <limits>

#include "polynomial.hpp"
#include "simulation/chain/tolerances.hpp"
#include "simulation/chain/twofold.hpp"
#include "vibro_impact/instant.hpp"

namespace vibro_impact::detail {

namespace {

// Sums run over packets of four terms c_n u^n, because a chain of dependent operations as long as
// the polynomial would be slower.
struct Packet {
  Pair first{}, last{};

  friend Packet operator*(const Packet &a, const Packet &b) {
    return {a.first * b.first, a.last * b.last};
  }
  Packet &operator+=(const Packet &other) {
    first += other.first;
    last += other.last;
    return *this;
  }
  double sum() const {
    const Pair both = first + last;
    return both[0] + both[1];
  }
};

// binomial[k][n] = n! / (k! (n - k)!). The k-th derivative of u^n is k! binomial[k][n] u^(n - k).
const auto binomial = [] {
  std::array<Terms, 6> table{};
  for (std::size_t n = 0; n < table[0].size(); ++n) {
    table[0][n] = 1.0;
    for (std::size_t k = 1; k < table.size() && n > 0; ++k)
      table[k][n] = table[k][n - 1] + table[k - 1][n - 1];
  }
  return table;
}();

Packet packet(const double *numbers) {
  return {pair(numbers), pair(numbers + 2)};
}

Packet moduli(const Packet &a) {
  return {modulus(a.first), modulus(a.last)};
}

// 1, x, x^2, x^3.
Packet powers_of(double x) {
  return {Pair{1.0, x}, Pair{x * x, x * x * x}};
}

// The factor that leads to the next four powers.
Packet fourth_power_of(double x) {
  const double power = x * x * x * x;
  return {Pair{power, power}, Pair{power, power}};
}

Packet binomials(int k, int n) {
  return packet(binomial[static_cast<std::size_t>(k)].data() + n);
}

}  // namespace

Jet jet_at(const Polynomial &p, int zeros, double u) {
  const double *c = p.coefficient.data() + zeros;
  const double inverse = 1.0 / std::max(u, std::numeric_limits<double>::min());
  const Packet next = fourth_power_of(u);
  Packet power = powers_of(u);
  Packet value, slope, second, third, fourth;
  for (int n = 0; n <= p.order - zeros; n += 4) {
    const Packet term = packet(c + n) * power;
    value += term;
    slope += binomials(1, n) * term;
    second += binomials(2, n) * term;
    third += binomials(3, n) * term;
    fourth += binomials(4, n) * term;
    power = power * next;
  }
  // The products run from left to right: a sum that has underflown stays zero.
  return {value.sum(), slope.sum() * inverse, second.sum() * inverse * inverse,
          third.sum() * inverse * inverse * inverse,
          fourth.sum() * inverse * inverse * inverse * inverse};
}

namespace {

// The sum of the moduli of the terms of q^(k) / k! at u, q(u) = p(u) / u^zeros. It bounds q^(k) /
// k! on [0, u].
inline double sum_of_moduli(int k, const Polynomial &p, int zeros, double u) {
  const double *c = p.coefficient.data() + zeros + k;
  const Packet next = fourth_power_of(u);
  Packet sum, power = powers_of(u);
  for (int n = 0; n <= p.order - zeros - k; n += 4) {
    sum += binomials(k, n + k) * moduli(packet(c + n)) * power;
    power = power * next;
  }
  return sum.sum();
}

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
    const double fifth_to_end = end < 0.25 ? sum_of_moduli(5, p, zeros, end) : fifth;
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
  const double fifth = sum_of_moduli(5, p, zeros, u_max);
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
        polynomial_rounding * (u > 0.0 ? sum_of_moduli(0, p, zeros, u) : jet.value);
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
