#include "taylor_table.hpp"

#include <algorithm>
#include <cmath>

#include "simulation/chain/tolerances.hpp"

namespace vibro_impact::detail {

namespace {

// n, n (n - 1) and its reciprocal, for two masses. The wave looks at most four orders beyond the
// highest one.
struct OrderFactors {
  Pair order, product, inverse;
};

const auto factors_of = [] {
  std::array<OrderFactors, max_order + 5> factors{};
  for (std::size_t n = 2; n < factors.size(); ++n) {
    const auto order = static_cast<double>(n);
    const Pair both{order, order}, product = both * (both - 1.0);
    factors[n] = {both, product, 1.0 / product};
  }
  return factors;
}();

const OrderFactors &factors(int n) {
  return factors_of[static_cast<std::size_t>(n)];
}

// a cos(Omega t) + b sin(Omega t) and its rate over Omega, at the start of the step.
template <class T>
struct Parts {
  T even, odd;
};
template <class T>
Parts<T> parts_of(const Turn &turn, const T &a, const T &b) {
  return {a * turn.cosine.hi + b * turn.sine.hi, b * turn.cosine.hi - a * turn.sine.hi};
}

// The forcing of two masses, times (Omega h)^(n - 2) / n!, is part of their coefficients of order
// n, with alternating signs and with even and odd parts in turn.
void expand_forcing(const Chain &chain, const Motion &motion, TaylorTable &table) {
  const double unit = table.step.unit, square = unit * unit, angle = chain.omega * unit;
  if (angle != table.wave_angle) {
    table.wave_angle = angle;
    Pair wave{0.5, angle / 6.0};
    for (int n = 2; n <= max_order + 1; n += 2) {
      put(wave, &table.wave[static_cast<std::size_t>(n)]);
      wave *= -(angle * angle) * Pair{factors(n + 2).inverse[0], factors(n + 3).inverse[0]};
    }
  }
  for (const std::size_t i : motion.mode->forced_pairs) {
    const Pair scale = square * pair(&motion.mode->inverse_mass[i]);
    const auto [even, odd] = parts_of<Pair>(motion.turn, pair(&chain.a[i]), pair(&chain.b[i]));
    put(scale * even, &table.even[i]);
    put(scale * odd, &table.odd[i]);
  }
}

// All orders of a chain of one or two masses, which fit into one register. By `expand_order`,
// Figure 2 would take a fifth more time. An order needs the one before. The products that do not
// need it come first.
void expand_pair(const Chain &chain, const ContactMode &mode, TaylorTable &table) {
  const double unit = table.step.unit, square = unit * unit;
  const Pair mass = pair(mode.mass.data()), inverse = pair(mode.inverse_mass.data()),
             within = square * Pair{chain.link[1], chain.link[1]},
             own = square * (Pair{chain.link[0], 0.0} + pair(chain.ground.data())),
             damping = chain.beta / unit * Pair{1.0, 1.0};
  const bool forced = !mode.forced_pairs.empty();
  const Pair even = forced ? pair(table.even.data()) : Pair{},
             odd = forced ? pair(table.odd.data()) : Pair{};
  double *entry = table.of_order(2);
  Pair before = pair(table.of_order(1)), latest = pair(entry), travel = modulus(latest);
  const auto next = [&](int n, const Pair &force) {
    const Pair z = before + damping * factors(n - 1).order * latest, stretch = z - exchanged(z),
               forcing = force * table.wave[static_cast<std::size_t>(n)];
    before = latest;
    if (n > last_divided_order) {
      const Pair scale = inverse * factors(n).inverse;
      latest = (forcing - (scale * own) * z) - (scale * within) * stretch;
    } else {
      latest = forcing - (own * z + within * stretch) / mass / factors(n).product;
    }
    travel += modulus(latest);
    put(latest, entry += 2);
  };
  for (int n = 3; n <= table.step.order + 1; n += 2) {  // the order is odd
    next(n, odd);
    next(n + 1, even);
  }
  put(travel, table.travel.data());
}

// One order of a longer chain, where the pairs of masses do not wait for each other.
template <bool grounded>
void expand_order(const Chain &chain, const ContactMode &mode, int n, TaylorTable &table) {
  const double unit = table.step.unit, square = unit * unit;
  const Pair damping = chain.beta / unit * factors(n - 1).order,
             scale = square * factors(n).inverse;
  const std::size_t stride = table.stride;
  const double *before = table.of_order(n - 2), *latest = table.of_order(n - 1),
               *link = chain.link.data(), *ground = chain.ground.data(), *mass = mode.mass.data(),
               *inverse = mode.inverse_mass.data();
  double *to = table.of_order(n);
  const auto z_of = [&](std::size_t i) { return pair(before + i) + damping * pair(latest + i); };
  const auto tension_of = [&](std::size_t i, const Pair &left, const Pair &z) {
    return pair(link + i) * (z - middle(left, z));
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
    const Pair right = z_of(i), next = tension_of(i, z, right);
    set(i - 2, z, tension, next);
    z = right;
    tension = next;
  }
  set(stride - 2, z, tension, Pair{});
  const double wave = table.wave[static_cast<std::size_t>(n)];
  const std::vector<double> &part = n % 2 == 0 ? table.even : table.odd;
  for (const std::size_t i : mode.forced_pairs) put(pair(to + i) + wave * pair(&part[i]), to + i);
}

void add_travel(const ContactMode &mode, TaylorTable &table) {
  for (const std::size_t i : mode.stopped_pairs) {
    const double *entry = table.of_order(2) + i;
    Pair sum{};
    for (int n = 2; n <= table.step.order + 1; ++n, entry += table.stride)
      sum += modulus(pair(entry));
    put(sum, &table.travel[i]);
  }
}

}  // namespace

OrderTable::OrderTable(double tolerance) {
  double factorial = 6.0;
  for (std::size_t k = 0; k < longest_.size(); ++k) {
    const auto p = 2.0 * static_cast<double>(k) + 3.0;
    factorial *= (p + 1.0) * (k == 0 ? 1.0 : p);
    longest_[k] = std::pow(0.5 * tolerance * factorial, 1.0 / (p - 1.0));
  }
}

int OrderTable::order_of(double radians) const {
  std::size_t k = longest_.size() - 1;  // most steps are long
  while (k > 0 && radians <= longest_[k - 1]) --k;
  return 2 * static_cast<int>(k) + 3;
}

void expand(const Chain &chain, const Motion &motion, const Step &step, TaylorTable &table) {
  const ContactMode &mode = *motion.mode;
  table.step = step;
  if (table.stride != chain.padded) {
    table.stride = chain.padded;
    table.coefficients.resize((max_order + 2) * table.stride);
    for (std::vector<double> *list : {&table.travel, &table.even, &table.odd})
      list->resize(table.stride);
  }
  const double unit = step.unit, half_square = 0.5 * unit * unit;
  double *first = table.of_order(1), *second = table.of_order(2);
  for (std::size_t i = 0; i < table.stride; i += 2) {
    put(unit * Pair{motion.v[i].hi, motion.v[i + 1].hi}, first + i);
    put(half_square * pair(&motion.acceleration[i]), second + i);
  }
  expand_forcing(chain, motion, table);
  if (table.stride == 2) return expand_pair(chain, mode, table);
  for (int n = 3; n <= step.order + 1; ++n) {
    if (mode.grounded)
      expand_order<true>(chain, mode, n, table);
    else
      expand_order<false>(chain, mode, n, table);
  }
  add_travel(mode, table);
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
    value = u * (u * value);  // u^2 would be rounded alike in every step of a length
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

}  // namespace vibro_impact::detail
