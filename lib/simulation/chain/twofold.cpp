#include "twofold.hpp"

#include <array>

namespace vibro_impact::detail {

namespace {

constexpr Real log_2{6.931471805599452862e-01, 2.319046813846299558e-17};
// pi / 2 is the sum of these three doubles.
constexpr Real quarter_turn{1.570796326794896558e+00, 6.123233995736766036e-17};
constexpr double quarter_turn_rest = -1.4973849048591698e-33;

// 1 / (2n)! and 1 / (2n + 1)!.
constexpr std::size_t even_terms = 14;
const auto inverse_factorials = [] {
  std::array<RealPair, even_terms> inverse{};
  Real even = 1.0;
  for (std::size_t n = 0; n < even_terms; ++n) {
    const Real odd = even / static_cast<double>(2 * n + 1);
    inverse[n] = {Pair{even.hi, odd.hi}, Pair{even.lo, odd.lo}};
    even = odd / static_cast<double>(2 * n + 2);
  }
  return inverse;
}();

// The sums of square^n / (2n)! and of square^n / (2n + 1)!, side by side, for |square| below
// (pi / 4)^2. The terms from order 18 on lie below 2^-53 and are summed in double precision.
std::array<Real, 2> even_and_odd(const Real &square) {
  constexpr std::size_t rounded_from = 9;
  const RealPair s = both(square);
  Pair high_orders{};
  std::size_t n = even_terms;
  while (n > rounded_from) high_orders = high_orders * s.hi + inverse_factorials[--n].hi;
  RealPair sum = high_orders;
  while (n > 0) sum = sum * s + inverse_factorials[--n];
  std::array<Real, 2> sums;
  store(sum, sums.data());
  return sums;
}

}  // namespace

// One step of Newton's from the root in double precision.
Real sqrt(const Real &x) {
  if (!(x.hi > 0.0)) return 0.0;
  const double inverse = 1.0 / std::sqrt(x.hi), root = x.hi * inverse;
  return Real::quick_sum(root, (x - Real::exact_product(root, root)).hi * (0.5 * inverse));
}

// x = r + k log 2 with |r| <= log(2) / 2. exp r = cosh r + sinh r has the series of both in r^2.
Real exp(const Real &x) {
  if (!(x.hi > -745.0)) return 0.0;  // below the least double
  if (x.hi > 709.0) return INFINITY;
  const double k = std::round(x.hi / log_2.hi);
  const Real r = x - log_2 * k;
  const auto [even, odd] = even_and_odd(r * r);
  const Real sum = even + r * odd;
  return {std::ldexp(sum.hi, static_cast<int>(k)), std::ldexp(sum.lo, static_cast<int>(k))};
}

// x = r + k pi / 2 with |r| <= pi / 4. cos r and (sin r) / r are series in -r^2.
void sincos(const Real &x, Real &sine, Real &cosine) {
  const double k = std::nearbyint(x.hi / quarter_turn.hi);
  const Real r = x - quarter_turn * k - quarter_turn_rest * k;
  const auto [c, sine_over_r] = even_and_odd(-(r * r));
  const Real s = sine_over_r * r;
  const int quarter = static_cast<int>(static_cast<long long>(k) & 3);
  sine = quarter % 2 == 0 ? s : c;
  cosine = quarter % 2 == 0 ? c : s;
  if (quarter == 2 || quarter == 3) sine = -sine;
  if (quarter == 1 || quarter == 2) cosine = -cosine;
}

Pair higher_orders_of_turn(double w) {
  const double square = -w * w, fourth = square * square;
  static_assert(even_terms % 2 == 0);
  Pair even{}, odd{};  // of the orders in square: two chains of operations side by side
  for (std::size_t n = even_terms - 1; n > 1; n -= 2) {
    odd = odd * fourth + inverse_factorials[n].hi;
    even = even * fourth + inverse_factorials[n - 1].hi;
  }
  const Pair sum = odd * fourth + inverse_factorials[1].hi;
  return (sum + even * square) * Pair{square, w * square};
}

}  // namespace vibro_impact::detail
