#include "taylor_table.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "simulation/chain/pair.hpp"
#include "simulation/chain/steady_response.hpp"
#include "simulation/chain/tolerances.hpp"

namespace vibro_impact::detail {

namespace {

using Eigen::Index;

// Factors of the recurrences for both coordinates of a pair: 1 / (n + 1), 1 / ((n + 1) (n + 2)),
// and n.
struct Factors {
  std::array<Pair, max_order + 3> inverse, inverse_square, order;
};

const Factors factors = [] {
  Factors table{};
  for (std::size_t k = 0; k < table.order.size(); ++k) {
    const auto n = static_cast<double>(k);
    table.inverse[k] = Pair{} + 1.0 / (n + 1.0);
    table.inverse_square[k] = Pair{} + 1.0 / ((n + 1.0) * (n + 2.0));
    table.order[k] = Pair{} + n;
  }
  return table;
}();

// Two coordinates of (1) in units of the step.
struct PairOfOscillators {
  Pair kappa, lambda, force_re, force_im, constant;
};

// A coordinate that follows its steady response obeys y'' + Omega^2 y = 0.
PairOfOscillators oscillators(const Motion &motion, double omega, double length, Index j) {
  const ModalCoordinates &all = motion.mode->coordinates;
  PairOfOscillators two{pair(all.kappa.data() + j), pair(all.lambda.data() + j),
                        pair(all.force_re.data() + j), pair(all.force_im.data() + j), Pair{}};
  if (all.any_beside_cosine) two.constant = pair(all.constant.data() + j);
  for (Index i = 0; i < 2 && motion.any_following; ++i)
    if (motion.following[static_cast<std::size_t>(j + i)]) {
      two.kappa[i] = two.force_re[i] = two.force_im[i] = 0.0;
      two.lambda[i] = omega * omega;
      two.constant[i] = omega * omega * all.static_value(j + i);
    }
  const double square = length * length;
  two.kappa *= length;
  two.lambda *= square;
  two.force_re *= square;
  two.force_im *= square;
  if (all.any_beside_cosine) two.constant *= square;
  return two;
}

void size_table(double length, int order, Index coordinates, TaylorTable &table) {
  table.length = length;
  table.order = order;
  table.coordinates = coordinates;
  const auto size = static_cast<std::size_t>((max_order + 3) * coordinates);
  if (table.coefficients.size() < size) table.coefficients.resize(size);
}

// The coefficients of cos(Omega (t + u length)), and of the sine where `with_sine`.
void expand_forcing(std::complex<double> turn, double angle, bool with_sine, TaylorTable &table) {
  const double square = -angle * angle;
  table.cosine[0] = turn.real();
  table.cosine[1] = -angle * turn.imag();
  table.sine[0] = turn.imag();
  table.sine[1] = angle * turn.real();
  const auto last = static_cast<std::size_t>(table.order);
  for (std::size_t n = 0; n + 2 <= last; ++n)
    table.cosine[n + 2] = square * table.cosine[n] * factors.inverse_square[n][0];
  for (std::size_t n = 0; with_sine && n + 2 <= last; ++n)
    table.sine[n + 2] = square * table.sine[n] * factors.inverse_square[n][0];
}

// Which terms of a force take part in a recurrence.
enum class Forcing { none, cosine, any };

// The recurrence (4), y_(n+2) = (F_n - lambda y_n) / ((n+1) (n+2)) - kappa y_(n+1) / (n+2), for two
// coordinates, from their values and slopes, in units of the step. Two orders at a time; one more
// than needed does no harm.
template <Forcing forcing>
void expand_pair(const PairOfOscillators &two, Pair value, Pair slope, Index j,
                 TaylorTable &table) {
  const Index stride = table.coordinates;
  double *next = table.coefficients.data() + j;
  store(value, next);
  store(slope, next += stride);
  const auto coefficient = [&](std::size_t n, Pair before, Pair latest) {
    Pair spring = two.lambda * before;  // or its difference from the force
    if (forcing != Forcing::none) spring = two.force_re * table.cosine[n] - spring;
    if (forcing == Forcing::any) spring -= two.force_im * table.sine[n];
    spring *= factors.inverse_square[n];
    const Pair damping = two.kappa * latest * factors.inverse[n + 1];
    return forcing == Forcing::none ? -(spring + damping) : spring - damping;
  };
  const auto orders = static_cast<std::size_t>(table.order);
  for (std::size_t n = 0; n < orders; n += 2) {
    value = coefficient(n, value, slope);
    if (forcing == Forcing::any && n == 0) value += two.constant * factors.inverse_square[0];
    store(value, next += stride);
    slope = coefficient(n + 1, slope, value);
    store(slope, next += stride);
  }
}

}  // namespace

OrderTable::OrderTable(double tolerance) {
  double factorial = 6.0;
  int p = 3;
  for (double &radians : longest_) {
    for (int n = p == 3 ? 4 : p - 2; n <= p + 1; ++n) factorial *= n;
    radians = std::pow(tolerance * factorial / 2.0, 1.0 / (p - 1));
    p += 4;
  }
}

int OrderTable::order_of(double radians) const {
  int order = 3;
  for (const double longest : longest_) {
    if (radians <= longest) break;
    order += 4;
  }
  return std::min(order, max_order);
}

void expand(const Motion &motion, const Step &step, double omega, bool forced, TaylorTable &table) {
  const ModalCoordinates &all = motion.mode->coordinates;
  size_table(step.length, step.order, motion.y.size(), table);
  if (forced) expand_forcing(motion.turn, omega * step.length, all.any_beside_cosine, table);
  for (Index j = 0; j < table.coordinates; j += 2) {
    const PairOfOscillators two = oscillators(motion, omega, step.length, j);
    const Pair value = pair(motion.y.data() + j), slope = pair(motion.dy.data() + j) * step.length;
    if (all.any_beside_cosine)
      expand_pair<Forcing::any>(two, value, slope, j, table);
    else if (forced)
      expand_pair<Forcing::cosine>(two, value, slope, j, table);
    else
      expand_pair<Forcing::none>(two, value, slope, j, table);
  }
}

void sum_row(const TaylorTable &table, const PerCoordinate &row, int last, Terms &sums) {
  const Index stride = table.coordinates;
  const double *weights = row.data(), *column = table.coefficients.data();
  const Pair first = pair(weights);
  for (int n = 0; n <= last; n += 2, column += 2 * stride) {  // two orders at a time
    Pair even = first * pair(column), odd = first * pair(column + stride);
    for (Index j = 2; j < stride; j += 2) {
      even += pair(weights + j) * pair(column + j);
      odd += pair(weights + j) * pair(column + stride + j);
    }
    const Pair low = __builtin_shufflevector(even, odd, 0, 2),
               high = __builtin_shufflevector(even, odd, 1, 3);
    store(low + high, sums.data() + n);
  }
}

void read_along(const TaylorTable &table, const Contact &contact, Polynomial &polynomial) {
  Terms &p = polynomial.coefficient;
  sum_row(table, contact.row, table.order + 1, p);
  if (contact.held) {
    const double damping = contact.damping / table.length;
    const auto orders = static_cast<std::size_t>(table.order);
    for (std::size_t n = 0; n <= orders; n += 2) {
      const Pair order = Pair{} + static_cast<double>(n) + Pair{1.0, 2.0};
      const Pair sum = pair(p.data() + n) + damping * order * pair(p.data() + n + 1) +
                       contact.forcing.real() * pair(table.cosine.data() + n);
      store(sum, p.data() + n);
    }
    for (std::size_t n = 0; n <= orders && contact.forcing.imag() != 0.0; ++n)
      p[n] -= contact.forcing.imag() * table.sine[n];
  }
  polynomial.order = table.order;
  std::fill_n(p.begin() + table.order + 1, 4, 0.0);
  p[0] += contact.offset;
}

void move_coordinates(const TaylorTable &table, double u, const Clock &clock, Motion &motion) {
  const Index stride = table.coordinates;
  const auto last = static_cast<std::size_t>(table.order + 1);
  const double tau = u * table.length;
  const std::complex<double> turn = motion.turn;
  pass_time(motion, clock, tau);
  const bool by_deviation = any_moves_by_deviation(motion, clock.omega, tau);
  for (Index j = 0; j < stride; j += 2) {
    const double *column = table.of_order(table.order + 1) + j;
    // The sums over n >= 2 of y_n u^(n-2) and n y_n u^(n-2).
    Pair value = pair(column), slope = factors.order[last] * value;
    for (std::size_t n = last - 1; n >= 2; --n) {
      const Pair coefficient = pair(column -= stride);
      value = value * u + coefficient;
      slope = slope * u + factors.order[n] * coefficient;
    }
    const Twofold<Pair> y = twofold(motion.y, motion.y_low, j),
                        dy = twofold(motion.dy, motion.dy_low, j),
                        travel = exact_product(dy.value, Pair{} + tau),
                        sum = exact_sum(y.value, travel.value);
    const Pair rest = (u * u) * value + tau * dy.low + travel.low + y.low;
    store(exact_sum(sum.value, sum.low + rest), motion.y, motion.y_low, j);
    store(dy + (u / table.length) * slope, motion.dy, motion.dy_low, j);
    for (Index i = 0; i < 2 && by_deviation; ++i)
      if (moves_by_deviation(motion, j + i, clock.omega, tau))
        move_by_deviation(motion, j + i, {{y.value[i], y.low[i]}, {dy.value[i], dy.low[i]}}, turn,
                          clock.omega, tau, 0.0);
  }
  tie_decays(motion);
}

}  // namespace vibro_impact::detail
