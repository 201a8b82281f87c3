#include "taylor_table.hpp"

#include <algorithm>
#include <cmath>

#include "simulation/chain/tolerances.hpp"

namespace vibro_impact::detail {

namespace {

// Factors of the order n, for two masses.
struct OrderFactors {
  Pair order, product, inverse;         // n, n (n - 1) and its reciprocal
  Pair derivative, inverse_derivative;  // n! / 4^n and its reciprocal
};

// The highest order of a step, order + 1, and one beyond it for the forcing.
const auto factors_of = [] {
  std::array<OrderFactors, max_order + 3> factors{};
  Pair derivative = Pair{1.0, 1.0} / 4.0;
  for (std::size_t n = 2; n < factors.size(); ++n) {
    const auto order = static_cast<double>(n);
    const Pair both{order, order}, product = both * (both - 1.0);
    derivative *= both / 4.0;
    factors[n] = {both, product, 1.0 / product, derivative, 1.0 / derivative};
  }
  return factors;
}();

const OrderFactors &factors(int n) {
  return factors_of[static_cast<std::size_t>(n)];
}

// a cos(Omega t) + b sin(Omega t) and its rate over Omega, at the start of the step. The forcing is
// part of the orders with alternating signs, by these two in turn.
template <class T>
struct Parts {
  T even, odd;
};
template <class T>
Parts<T> parts_of(const Turn &turn, const T &a, const T &b) {
  return {a * turn.cosine.hi + b * turn.sine.hi, b * turn.cosine.hi - a * turn.sine.hi};
}

// All orders of a chain of one or two masses, which fit into one register, by the derivatives
// y_n = n! x_n / 4^n in the unit of time q = h / 4, in which they do not grow:
//   y_n = f_n - q^2 M^-1 K y_(n-2) - beta q M^-1 K y_(n-1)
// An order waits for the one before. Hence all that y_(n-1) is multiplied by is found before the
// loop, and what is left between two orders is a stretch, a product and a difference.
void expand_pair(const Chain &chain, const Motion &motion, TaylorTable &table) {
  const ContactMode &mode = *motion.mode;
  const double quarter = 0.25 * table.step.unit, square = quarter * quarter,
               angle = chain.omega * quarter, damping = chain.beta / quarter;
  const Pair mass = pair(mode.mass.data()), inverse = pair(mode.inverse_mass.data());
  Pair within = square * Pair{chain.link[1], chain.link[1]},
       own = square * (Pair{chain.link[0], 0.0} + pair(chain.ground.data()));
  const Pair damped_within = damping * within / mass, damped_own = damping * own / mass;
  const auto [even, odd] = parts_of<Pair>(motion.turn, pair(chain.a.data()), pair(chain.b.data()));
  // The mass comes first: of a small mass and a small length, the product may leave the range.
  Pair odd_forcing = square * angle * (odd / mass),
       even_forcing = -(square * angle * angle) * (even / mass);

  double *entry = table.of_order(2);
  Pair latest = 0.25 * pair(table.of_order(1));
  Pair springs = (own * latest + within * (latest - exchanged(latest))) / mass;  // of y_(n-2)
  latest = 0.125 * pair(entry);
  Pair travel = modulus(pair(entry));
  // Goes on by an order, and returns the force of the springs of the one before.
  const auto next = [&](Pair &forcing) {
    const Pair stretch = latest - exchanged(latest), force = own * latest + within * stretch;
    latest = ((forcing - springs) - damped_own * latest) - damped_within * stretch;
    forcing *= -(angle * angle);
    return force;
  };
  const auto add = [&](const Pair &coefficient) {
    travel += modulus(coefficient);
    put(coefficient, entry += 2);
  };
  const int last = table.step.order + 1;  // an even order
  int n = 3;
  for (; n < std::min(last, last_divided_order); n += 2) {
    springs = next(odd_forcing) / mass;
    add(latest / factors(n).derivative);
    springs = next(even_forcing) / mass;
    add(latest / factors(n + 1).derivative);
  }
  own *= inverse;  // from here on, over the mass
  within *= inverse;
  for (; n < last; n += 2) {
    springs = next(odd_forcing);
    add(latest * factors(n).inverse_derivative);
    springs = next(even_forcing);
    add(latest * factors(n + 1).inverse_derivative);
  }
  put(travel, table.travel.data());
}

// One order of a longer chain, where the pairs of masses do not wait for each other.
template <bool grounded>
void expand_order(const Chain &chain, const ContactMode &mode, int n, double wave,
                  const double *forcing, TaylorTable &table) {
  const double unit = table.step.unit, square = unit * unit;
  const Pair damping = chain.beta / unit * factors(n - 1).order,
             scale = square * factors(n).inverse;
  const std::size_t stride = table.stride;
  const double *before = table.of_order(n - 2), *latest = table.of_order(n - 1),
               *link = chain.link.data(), *ground = chain.ground.data(), *mass = mode.mass.data(),
               *inverse = mode.inverse_mass.data();
  double *to = table.of_order(n);
  const auto z_of = [&](std::size_t i) { return pair(before + i) + damping * pair(latest + i); };
  const auto tension_of = [&](std::size_t i, const Pair &lower, const Pair &z) {
    return pair(link + i) * (z - middle(lower, z));
  };
  // The force of order n - 2 over the mass and n (n - 1).
  const auto set = [&](std::size_t i, const Pair &z, const Pair &tension, const Pair &next) {
    Pair force = middle(tension, next) - tension;
    if constexpr (grounded) force -= pair(ground + i) * z;
    if (n > last_divided_order)
      put(force * (pair(inverse + i) * scale), to + i);
    else
      put(square * force / pair(mass + i) / factors(n).product, to + i);
  };
  Pair z = z_of(0), tension = tension_of(0, Pair{}, z);
  for (std::size_t i = 2; i < stride; i += 2) {
    const Pair higher = z_of(i), next = tension_of(i, z, higher);
    set(i - 2, z, tension, next);
    z = higher;
    tension = next;
  }
  set(stride - 2, z, tension, Pair{});
  for (const std::size_t i : chain.forced_pairs)
    put(pair(to + i) + wave * pair(forcing + i), to + i);
}

void add_travel(const Chain &chain, TaylorTable &table) {
  for (const std::size_t i : chain.stopped_pairs) {
    const double *entry = table.of_order(2) + i;
    Pair sum{};
    for (int n = 2; n <= table.step.order + 1; ++n, entry += table.stride)
      sum += modulus(pair(entry));
    put(sum, &table.travel[i]);
  }
}

// The orders of a chain of three or more masses.
template <bool grounded>
void expand_chain(const Chain &chain, const Motion &motion, TaylorTable &table) {
  const ContactMode &mode = *motion.mode;
  const double unit = table.step.unit, angle = chain.omega * unit;
  for (const std::size_t i : chain.forced_pairs) {
    const Pair scale = unit * unit * pair(&mode.inverse_mass[i]);
    const auto [even, odd] = parts_of<Pair>(motion.turn, pair(&chain.a[i]), pair(&chain.b[i]));
    put(scale * even, &table.even[i]);
    put(scale * odd, &table.odd[i]);
  }
  Terms wave;  // (Omega h)^(n-2) / n! with its sign
  wave[2] = 0.5;
  wave[3] = angle / 6.0;
  for (int n = 3; n <= table.step.order + 1; ++n) {
    const auto order = static_cast<std::size_t>(n);
    wave[order + 1] = -(angle * angle) * factors(n + 1).inverse[0] * wave[order - 1];
    const std::vector<double> &part = n % 2 == 0 ? table.even : table.odd;
    expand_order<grounded>(chain, mode, n, wave[order], part.data(), table);
  }
  add_travel(chain, table);
}

}  // namespace

int order_of(double radians, double tolerance) {
  const double square = radians * radians;
  double remainder = square / 12.0;
  int order = 3;
  for (; order < max_order && remainder > tolerance; order += 2)
    remainder *= square * factors(order + 3).inverse[0];
  return order;
}

void expand(const Chain &chain, const Motion &motion, const Step &step, TaylorTable &table) {
  table.step = step;
  const bool is_pair = chain.padded == 2;
  if (table.stride != chain.padded) {
    table.stride = chain.padded;
    table.coefficients.resize((max_order + 2) * table.stride);
    table.travel.resize(table.stride);
    if (!is_pair) {
      table.even.resize(table.stride);
      table.odd.resize(table.stride);
    }
  }
  const double unit = step.unit, half_square = 0.5 * unit * unit;
  double *first = table.of_order(1), *second = table.of_order(2);
  for (std::size_t i = 0; i < table.stride; i += 2) {
    put(unit * Pair{motion.v[i].hi, motion.v[i + 1].hi}, first + i);
    put(half_square * pair(&motion.acceleration[i]), second + i);
  }
  if (is_pair) return expand_pair(chain, motion, table);
  if (chain.grounded)
    expand_chain<true>(chain, motion, table);
  else
    expand_chain<false>(chain, motion, table);
}

void read(const Chain &chain, const Motion &start, const TaylorTable &table, const Contact &contact,
          Polynomial &p) {
  const std::size_t stride = table.stride, i = contact.mass;
  p.order = table.step.order;
  const auto orders = static_cast<std::size_t>(p.order);
  Terms &c = p.coefficient;
  std::fill_n(c.begin() + p.order + 1, 4, 0.0);
  if (!contact.held) {
    const double *entry = table.of_order(2) + i;
    for (std::size_t n = 2; n <= orders; ++n, entry += stride) c[n] = -contact.sigma * *entry;
    return;
  }
  const double angle = chain.omega * table.step.unit, scale = -contact.sigma * angle * angle;
  const auto [even, odd] = parts_of<double>(start.turn, scale * chain.a[i], scale * chain.b[i]);
  const double damping = chain.beta / table.step.unit;
  c[2] = 0.5 * even;
  c[3] = angle / 6.0 * odd;
  for (std::size_t n = 4; n <= orders; ++n)
    c[n] = -(angle * angle) * factors(static_cast<int>(n)).inverse[0] * c[n - 2];
  chain.each_link(i, [&](double stiffness, std::size_t other) {
    const double *entry = table.of_order(2) + other;
    const double weight = contact.sigma * stiffness;
    for (std::size_t n = 2; n <= orders; ++n, entry += stride)
      c[n] += weight * (entry[0] + damping * static_cast<double>(n + 1) * entry[stride]);
  });
}

}  // namespace vibro_impact::detail
