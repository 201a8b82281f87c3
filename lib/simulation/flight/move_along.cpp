// The motion of a chain along a step, from its Taylor table.
#include <cmath>

#include "simulation/chain/tolerances.hpp"
#include "taylor_table.hpp"

namespace vibro_impact::detail {

namespace {

// The change of displacement and velocity of two masses by the orders from 2 on.
struct Change {
  Pair value, slope;
};

// Horner's rule for the sum of x_n u^(n-2) and its derivative. The orders above `half` are a chain
// of operations of their own beside that of those below, as if they began at order 2.
inline Change change_at(const TaylorTable &table, std::size_t i, double tau) {
  const double unit = table.step.unit, u = tau / unit;
  const int last = table.step.order + 1, half = last / 2;  // the order is odd
  const double *low = table.of_order(half) + i, *high = table.of_order(last) + i;
  Pair value = pair(low), slope{}, high_slope = pair(high),
       high_value = high_slope * u + pair(high -= table.stride);
  double power = 1.0;  // u^(half - 2)
  for (int n = half; n > 2; --n) {
    slope = slope * u + value;
    value = value * u + pair(low -= table.stride);
    high_slope = high_slope * u + high_value;
    high_value = high_value * u + pair(high -= table.stride);
    power *= u;
  }
  slope += power * ((half - 1.0) * high_value + u * high_slope);
  value += power * (u * high_value);
  // u^2 would be rounded alike in every step of a length.
  return {u * (u * value), (u / unit) * (2.0 * value + u * slope)};
}

}  // namespace

Real exact_root(const TaylorTable &table, const Contact &closing, const Motion &motion,
                double tau) {
  const std::size_t i = closing.mass / 2 * 2, k = closing.mass % 2;
  const Change change = change_at(table, i, tau);
  const RealPair v = load(&motion.v[i]),
                 x = load(&motion.x[i]) + (v * Pair{tau, tau} + change.value);
  const double speed = (v + change.slope).hi[k],
               newton = rounded(closing.position - Real(x.hi[k], x.lo[k])) / speed;
  if (!(closing.sigma * speed > 0.0 && std::abs(newton) <= step_rounding * tau)) return tau;
  return Real::quick_sum(tau, newton);
}

void move_along(const Chain &chain, const TaylorTable &table, const Real &tau, Motion &motion) {
  for (std::size_t i = 0; i < table.stride; i += 2) {
    const auto [value, slope] = change_at(table, i, tau.hi);
    const RealPair x = load(&motion.x[i]), v = load(&motion.v[i]);
    const RealPair x_then = x + (v * Pair{tau.hi, tau.hi} + value), v_then = v + slope;
    // The change of the velocity over tau.lo lies below the rounding of its slope.
    store(x_then + tau.lo * v_then.hi, &motion.x[i]);
    store(v_then, &motion.v[i]);
    const Pair speed = modulus(v.hi), way = tau.hi * speed + modulus(value);
    put(way == 0.0 ? pair(&motion.x_terms[i]) : modulus(x.hi) + way, &motion.x_terms[i]);
    put(speed + modulus(slope), &motion.v_terms[i]);
  }
  pass_time(chain, tau, motion);
}

}  // namespace vibro_impact::detail
