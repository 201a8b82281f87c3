// The return of a mass that has just left its stop: the first root of a gap of which the speed
// falls all the way.
//
// The gap is p(u) = u q(u), and q nearly linear in a late chatter. Where q falls all the way to a
// negative value at u = 1 it has one root, which steps of order four find; elsewhere `first_root`
// does.
#pragma once

#include "first_root.hpp"

namespace vibro_impact {

namespace detail {

// True when q falls all the way from q(0) > 0 to q(1) < 0: its first term outweighs the others.
inline bool falls_to_a_root(const double *q, int degree) {
  Four sum = Four::Zero(), rise = sum;
  for (int n = 0; n <= degree; n += 4) {
    const Four at = four(q + n);
    sum += at;
    rise += four_binomials(1, n) * at.abs();
  }
  return q[0] > 0.0 && q[1] < 0.0 && rise.sum() < -2.0 * q[1] && sum.sum() < 0.0;
}

}  // namespace detail

// First root in (0, 1] of a gap that is zero at 0, where its slope is positive.
inline std::optional<Root> first_return(const Polynomial &gap, Counters &counters) {
  using detail::Four;
  const double *q = gap.coefficient.data() + 1;
  const int degree = gap.order - 1;
  if (!detail::falls_to_a_root(q, degree)) return first_root(gap, 1, 1.0, counters);
  const double per_slope = -1.0 / q[1], x = q[0] * per_slope, e = x * q[2] * per_slope,
               f = x * x * q[3] * per_slope;
  double u = x * (1.0 + e + f + 2.0 * e * e);
  for (int step = 0; step < 4 && u > 0.0 && u <= 1.0; ++step) {
    ++counters.root_iterations;
    // q(u + z u) = value + slope z + second z^2 + third z^3 + ...
    const double quartic = u * u * u * u;
    Four power = detail::four_powers(u);
    Four values = Four::Zero(), slopes = values, seconds = values, thirds = values;
    for (int n = 0; n <= degree; n += 4) {
      const Four term = detail::four(q + n) * power;
      values += term;
      slopes += detail::four_binomials(1, n) * term;
      seconds += detail::four_binomials(2, n) * term;
      thirds += detail::four_binomials(3, n) * term;
      power *= quartic;
    }
    const double slope = slopes.sum(), inverse = -1.0 / slope;
    const double newton = values.sum() * inverse, a = seconds.sum() * inverse,
                 b = thirds.sum() * inverse;
    const double z = newton * (1.0 + newton * (a + newton * (2.0 * a * a + b)));
    u *= 1.0 + z;
    if (std::abs(z) <= 0x1p-18 && u <= 1.0) {  // the slope there is known to O(z^3)
      ++counters.roots_searched;
      return Root{u, slope * (1.0 - z * (2.0 * a + 3.0 * b * z)) * (1.0 + z)};
    }
  }
  return first_root(gap, 1, 1.0, counters);
}

}  // namespace vibro_impact
