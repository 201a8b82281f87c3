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
  std::array<Real, 32> inverse{};
  for (std::size_t n = 1; n < inverse.size(); ++n) inverse[n] = Real(1.0) / static_cast<double>(n);
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
  for (std::size_t n = 2; n < 9; ++n) s += term = term * r * inverse_number[n];
  for (int n = 0; n < 9; ++n) s = s * 2.0 + s * s;
  s += 1.0;
  return {std::ldexp(s.hi, static_cast<int>(k)), std::ldexp(s.lo, static_cast<int>(k))};
}

// The series about the nearest multiple of pi / 2. Terms below the rounding of a double are added
// in doubles.
void sincos(const Real &x, Real &sine, Real &cosine) {
  const double k = std::nearbyint(x.hi / quarter_turn.hi);
  const Real r = x - quarter_turn * k - quarter_turn_rest * k, square = -(r * r);
  Real s = r, c = 1.0, sine_term = r, cosine_term = 1.0;
  std::size_t n = 1;
  for (; n < 28 && std::abs(cosine_term.hi) > 0x1p-53; n += 2) {
    c += cosine_term = cosine_term * square * (inverse_number[n] * inverse_number[n + 1]);
    s += sine_term = sine_term * square * (inverse_number[n + 1] * inverse_number[n + 2]);
  }
  double even = cosine_term.hi, odd = sine_term.hi, rest_even = 0.0, rest_odd = 0.0;
  for (; n < 34 && std::abs(even) > 0x1p-110; n += 2) {
    const auto order = static_cast<double>(n);
    rest_even += even *= square.hi / (order * (order + 1.0));
    rest_odd += odd *= square.hi / ((order + 1.0) * (order + 2.0));
  }
  c += rest_even;
  s += rest_odd;
  const int quarter = static_cast<int>(static_cast<long long>(k) & 3);
  sine = quarter % 2 == 0 ? s : c;
  cosine = quarter % 2 == 0 ? c : s;
  if (quarter == 2 || quarter == 3) sine = -sine;
  if (quarter == 1 || quarter == 2) cosine = -cosine;
}

}  // namespace vibro_impact::detail
