#include "taylor_table.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace vibro_impact::detail {

namespace {

// n, and 1 / (n (n - 1)) in twice the precision, for two masses.
struct OrderFactors {
  Pair order, inverse, inverse_low;
};

const auto factors_of = [] {
  std::array<OrderFactors, max_order + 3> factors{};
  for (std::size_t n = 2; n < factors.size(); ++n) {
    const auto order = static_cast<double>(n);
    const Real inverse = Real(1.0) / (order * (order - 1.0));
    factors[n].order = Pair{order, order};
    factors[n].inverse = Pair{inverse.hi, inverse.hi};
    factors[n].inverse_low = Pair{inverse.lo, inverse.lo};
  }
  return factors;
}();

const OrderFactors &factors(int n) {
  return factors_of[static_cast<std::size_t>(n)];
}

// A product with a reciprocal of twice the precision. A rounded reciprocal would err always in the
// same direction, and the energy of an elastic chain would drift.
Pair over(Pair sum, Pair inverse, Pair inverse_low) {
  return sum * inverse + sum * inverse_low;
}

// The force of order n - 2 over the mass and n (n - 1).
Pair coefficient(Pair force, const RealPair &inverse_mass, int n) {
  return over(over(force, inverse_mass.hi, inverse_mass.lo), factors(n).inverse,
              factors(n).inverse_low);
}

// a cos(Omega t) + b sin(Omega t) about the start has the coefficients w_n even, w_n odd.
template <class T>
struct Parts {
  T even, odd;
};
template <class T>
Parts<T> parts_of(const TaylorTable &table, const T &a, const T &b) {
  return {a * table.cosine + b * table.sine, b * table.cosine - a * table.sine};
}

void expand_forcing(const Chain &chain, const Motion &motion, TaylorTable &table) {
  const double angle = chain.omega * table.step.unit, square = -(angle * angle);
  table.cosine = motion.turn.cosine.hi;
  table.sine = motion.turn.sine.hi;
  Terms &wave = table.wave;
  wave[0] = 1.0;
  wave[1] = angle;
  for (std::size_t n = 2; n <= static_cast<std::size_t>(table.step.order) + 1; ++n)
    wave[n] = square * factors_of[n].inverse[0] * wave[n - 2];
}

// Two masses fit into one register.
void expand_pair(const Chain &chain, const ContactMode &mode, TaylorTable &table) {
  const double unit = table.step.unit, damping = chain.beta / unit;
  const double square = unit * unit;
  const RealPair inverse = load(mode.inverse_mass.data());
  const auto [even, odd] =
      parts_of<Pair>(table, square * pair(chain.a.data()), square * pair(chain.b.data()));
  const Pair within = square * pair(mode.within.data()),
             own = square * (pair(mode.outside.data()) + pair(chain.ground.data()));
  double *entry = table.of_order(2);
  Pair before = pair(table.of_order(1)), latest = pair(entry), travel = modulus(latest);
  const auto next = [&](int n, const Pair &force) {
    const Pair z = before + damping * (factors(n - 1).order * latest);
    const Pair sum = (force * table.wave[static_cast<std::size_t>(n - 2)] - own * z) -
                     within * (z - exchanged(z));
    before = latest;
    latest = coefficient(sum, inverse, n);
    travel += modulus(latest);
    put(latest, entry += 2);
  };
  for (int n = 3; n <= table.step.order + 1; n += 2) {  // the order is odd
    next(n, odd);
    next(n + 1, even);
  }
  put(travel, table.travel.data());
}

// One order of a longer chain.
template <bool grounded>
void expand_order(const Chain &chain, const ContactMode &mode, int n, TaylorTable &table) {
  const double unit = table.step.unit, square = unit * unit;
  const Pair damping = chain.beta / unit * factors(n - 1).order;
  const double *before = table.of_order(n - 2), *latest = table.of_order(n - 1);
  double *to = table.of_order(n);
  const auto z_of = [&](std::size_t i) { return pair(before + i) + damping * pair(latest + i); };
  Pair left{}, own = z_of(0);
  for (std::size_t i = 0; i < table.stride; i += 2) {
    const Pair right = i + 2 < table.stride ? z_of(i + 2) : Pair{};
    Pair sum = pair(&mode.within[i]) * (own - exchanged(own)) +
               pair(&mode.outside[i]) * (own - __builtin_shufflevector(left, right, 1, 2));
    if constexpr (grounded) sum += pair(&chain.ground[i]) * own;
    sum = coefficient(-square * sum, load(&mode.inverse_mass[i]), n);
    put(pair(&table.travel[i]) + modulus(sum), &table.travel[i]);
    put(sum, to + i);
    left = own;
    own = right;
  }
  const double wave = table.wave[static_cast<std::size_t>(n - 2)];
  for (const std::size_t i : mode.forced_pairs) {
    const auto [even, odd] = parts_of<Pair>(table, pair(&chain.a[i]), pair(&chain.b[i]));
    const Pair force = wave * (n % 2 == 0 ? even : odd);
    const Pair change = coefficient(square * force, load(&mode.inverse_mass[i]), n);
    put(pair(to + i) + change, to + i);
    put(pair(&table.travel[i]) + modulus(change), &table.travel[i]);
  }
}

}  // namespace

OrderTable::OrderTable(double tolerance) {
  double factorial = 6.0;
  for (std::size_t k = 0; k < longest_.size(); ++k) {
    const int p = 4 * static_cast<int>(k) + 3;
    for (int n = k == 0 ? 4 : p - 2; n <= p + 1; ++n) factorial *= n;
    longest_[k] = std::pow(0.5 * tolerance * factorial, 1.0 / (p - 1));
  }
}

int OrderTable::order_of(double radians) const {
  std::size_t k = 0;
  while (k + 1 < longest_.size() && radians > longest_[k]) ++k;
  return 4 * static_cast<int>(k) + 3;
}

void expand(const Chain &chain, const Motion &motion, const Step &step, TaylorTable &table) {
  const ContactMode &mode = *motion.mode;
  table.step = step;
  table.stride = chain.padded;
  table.coefficients.resize((max_order + 2) * table.stride);
  table.travel.resize(table.stride);
  const double unit = step.unit, half_square = 0.5 * unit * unit;
  double *first = table.of_order(1), *second = table.of_order(2);
  for (std::size_t i = 0; i < table.stride; ++i) {
    first[i] = unit * motion.v[i].hi;
    second[i] = half_square * motion.acceleration[i].hi;
    table.travel[i] = std::abs(second[i]);
  }
  expand_forcing(chain, motion, table);
  if (table.stride == 2) return expand_pair(chain, mode, table);
  for (int n = 3; n <= step.order + 1; ++n) {
    if (mode.grounded)
      expand_order<true>(chain, mode, n, table);
    else
      expand_order<false>(chain, mode, n, table);
  }
}

void read(const Chain &chain, const TaylorTable &table, const Contact &contact, Polynomial &p) {
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
  const auto [even, odd] =
      parts_of<double>(table, contact.sigma * chain.a[i], contact.sigma * chain.b[i]);
  const double damping = chain.beta / table.step.unit;
  for (std::size_t n = 2; n <= orders; ++n) c[n] = (n % 2 == 0 ? even : odd) * table.wave[n];
  const auto add_link = [&](double stiffness, std::size_t other) {
    const double *entry = table.of_order(2) + other;
    const double weight = contact.sigma * stiffness;
    for (std::size_t n = 2; n <= orders; ++n, entry += stride)
      c[n] += weight * (entry[0] + damping * static_cast<double>(n + 1) * entry[stride]);
  };
  if (i > 0) add_link(chain.link[i], i - 1);
  if (i + 1 < chain.masses) add_link(chain.above(i), i + 1);
}

void move_along(const Chain &chain, const Clock &clock, const TaylorTable &table, double tau,
                Motion &motion) {
  const double unit = table.step.unit, u = tau / unit;
  for (std::size_t i = 0; i < table.stride; i += 2) {
    const double *entry = table.of_order(table.step.order + 1) + i;
    // Horner: q = sum over n >= 2 of x_n u^(n-2), and q'.
    Pair value = pair(entry), slope{};
    for (int n = table.step.order; n >= 2; --n) {
      slope = slope * u + value;
      value = value * u + pair(entry -= table.stride);
    }
    slope = (u / unit) * (2.0 * value + u * slope);
    value *= u * u;
    const RealPair x = load(&motion.x[i]), v = load(&motion.v[i]);
    const RealPair travel = v * Pair{tau, tau};
    store(x + (travel + value), &motion.x[i]);
    store(v + slope, &motion.v[i]);
    const Pair change = modulus(value), v_change = modulus(slope), speed = modulus(v.hi);
    put(change, &motion.x_change[i]);
    put(v_change, &motion.v_change[i]);
    put(modulus(x.hi) + tau * speed + change, &motion.x_terms[i]);
    put(speed + v_change, &motion.v_terms[i]);
  }
  pass_time(chain, clock, tau, motion);
}

Place place_at(const TaylorTable &table, const Motion &start, std::size_t mass, double tau) {
  const double unit = table.step.unit, u = tau / unit;
  const double *entry = table.of_order(table.step.order + 1) + mass;
  double value = *entry, slope = 0.0;
  for (int n = table.step.order; n >= 2; --n) {
    slope = slope * u + value;
    value = value * u + *(entry -= table.stride);
  }
  const Real &x = start.x[mass], &v = start.v[mass];
  return {x.hi + (tau * v.hi + (x.lo + value * u * u)),
          v.hi + (u / unit) * (2.0 * value + u * slope)};
}

}  // namespace vibro_impact::detail
