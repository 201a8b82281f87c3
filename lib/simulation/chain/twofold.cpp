#include "twofold.hpp"

#include <array>

namespace vibro_impact::detail {

namespace {

constexpr Real log_2{6.931471805599452862e-01, 2.319046813846299558e-17};
// pi / 2 is the sum of these three doubles.
constexpr Real quarter_turn{1.570796326794896558e+00, 6.123233995736766036e-17};
constexpr double quarter_turn_rest = -1.4973849048591698e-33;

// 1 / n.
const auto inverse_number = [] {
  std::array<Real, 9> inverse{};
  for (std::size_t n = 1; n < inverse.size(); ++n) inverse[n] = Real(1.0) / static_cast<double>(n);
  return inverse;
}();

// 1 / (2n)! and 1 / (2n + 1)!.
constexpr std::size_t circular_terms = 14;
const auto inverse_factorials = [] {
  std::array<RealPair, circular_terms> inverse{};
  Real even = 1.0;
  for (std::size_t n = 0; n < circular_terms; ++n) {
    const Real odd = even / static_cast<double>(2 * n + 1);
    inverse[n] = {Pair{even.hi, odd.hi}, Pair{even.lo, odd.lo}};
    even = odd / static_cast<double>(2 * n + 2);
  }
  return inverse;
}();

}  // namespace

// One step of Newton's from the root in double precision.
Real sqrt(const Real &x) {
  if (!(x.hi > 0.0)) return 0.0;
  const double inverse = 1.0 / std::sqrt(x.hi), root = x.hi * inverse;
  return Real::quick_sum(root, (x - Real::exact_product(root, root)).hi * (0.5 * inverse));
}

// exp(x) = 2^k (1 + s)^512, where s is the series of (x - k log 2) / 512.
Real exp(const Real &x) {
  if (!(x.hi > -745.0)) return 0.0;  // below the least double
  if (x.hi > 709.0) return INFINITY;
  const double k = std::round(x.hi / log_2.hi);
  const Real r = (x - log_2 * k) * 0x1p-9;
  Real s = r, term = r;
  for (std::size_t n = 2; n < inverse_number.size(); ++n) s += term = term * r * inverse_number[n];
  for (int n = 0; n < 9; ++n) s = s * 2.0 + s * s;
  s += 1.0;
  return {std::ldexp(s.hi, static_cast<int>(k)), std::ldexp(s.lo, static_cast<int>(k))};
}

// x = r + k pi / 2 with |r| <= pi / 4. cos r and (sin r) / r are series in -r^2, summed side by
// side. Their terms from order 18 on lie below 2^-53 and are summed in double precision.
void sincos(const Real &x, Real &sine, Real &cosine) {
  constexpr std::size_t rounded_from = 9;
  const double k = std::nearbyint(x.hi / quarter_turn.hi);
  const Real r = x - quarter_turn * k - quarter_turn_rest * k;
  const RealPair square = both(-(r * r));
  Pair high_orders{};
  std::size_t n = circular_terms;
  while (n > rounded_from) high_orders = high_orders * square.hi + inverse_factorials[--n].hi;
  RealPair sum = high_orders;
  while (n > 0) sum = sum * square + inverse_factorials[--n];
  std::array<Real, 2> parts;
  store(sum, parts.data());
  const Real c = parts[0], s = parts[1] * r;
  const int quarter = static_cast<int>(static_cast<long long>(k) & 3);
  sine = quarter % 2 == 0 ? s : c;
  cosine = quarter % 2 == 0 ? c : s;
  if (quarter == 2 || quarter == 3) sine = -sine;
  if (quarter == 1 || quarter == 2) cosine = -cosine;
}

Pair higher_orders_of_turn(double w) {
  const double square = -w * w;
  Pair sum{};
  for (std::size_t n = circular_terms; --n > 0;) sum = sum * square + inverse_factorials[n].hi;
  return sum * Pair{square, w * square};
}

}  // namespace vibro_impact::detail
