// Two modal coordinates in one vector register. Sums over the coordinates have few terms, for which
// the general expressions of Eigen are slow.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstring>

#include "contact_mode.hpp"

namespace vibro_impact::detail {

using Pair [[gnu::vector_size(16)]] = double;

inline Pair pair(const double *first) {
  Pair two;
  std::memcpy(&two, first, sizeof two);
  return two;
}

inline void store(Pair two, double *first) {
  std::memcpy(first, &two, sizeof two);
}

inline Pair abs(Pair two) {
  return Pair{std::abs(two[0]), std::abs(two[1])};
}

inline Pair smaller(Pair a, Pair b) {
  return Pair{std::min(a[0], b[0]), std::min(a[1], b[1])};
}

inline double sum(Pair two) {
  return two[0] + two[1];
}

// sum_j a_j b_j over an even number of coordinates.
inline double dot(const double *a, const PerCoordinate &b) {
  Pair total{};
  for (Eigen::Index j = 0; j < b.size(); j += 2) total += pair(a + j) * pair(b.data() + j);
  return sum(total);
}

inline double dot(const PerCoordinate &a, const PerCoordinate &b) {
  return dot(a.data(), b);
}

// sum_j (|a_j| + |b_j|).
inline double sum_of_moduli(const PerCoordinate &a, const PerCoordinate &b) {
  Pair total{};
  for (Eigen::Index j = 0; j < b.size(); j += 2)
    total += abs(pair(a.data() + j)) + abs(pair(b.data() + j));
  return sum(total);
}

// sum_j a_j |b_j|.
inline double dot_moduli(const double *a, const double *b, Eigen::Index size) {
  Pair total{};
  for (Eigen::Index j = 0; j < size; j += 2) total += pair(a + j) * abs(pair(b + j));
  return sum(total);
}

inline double dot_moduli(const PerCoordinate &a, const PerCoordinate &b) {
  return dot_moduli(a.data(), b.data(), a.size());
}

// The unevaluated sum value + low of twice the precision, where |low| lies below the rounding of
// value. The functions below are exact (Knuth; Dekker) unless the compiler reorders sums: a test
// guards that.
template <class Number>
struct Twofold {
  Number value{}, low{};
};

// Two coordinates of value + low.
inline Twofold<Pair> twofold(const PerCoordinate &value, const PerCoordinate &low, Eigen::Index j) {
  return {pair(value.data() + j), pair(low.data() + j)};
}

inline void store(const Twofold<Pair> &two, PerCoordinate &value, PerCoordinate &low,
                  Eigen::Index j) {
  store(two.value, value.data() + j);
  store(two.low, low.data() + j);
}

template <class Number>
Twofold<Number> exact_sum(Number a, Number b) {
  const Number sum = a + b, added = sum - a;
  return {sum, (a - (sum - added)) + (b - added)};
}

// The leading 26 bits of the numbers.
inline Pair leading_bits(Pair two) {
  using Bits [[gnu::vector_size(16)]] = long long;
  constexpr long long mask = ~0x7ffffffLL;
  return reinterpret_cast<Pair>(reinterpret_cast<Bits>(two) & Bits{mask, mask});
}

inline Twofold<Pair> exact_product(Pair a, Pair b) {
  const Pair product = a * b, a_high = leading_bits(a), b_high = leading_bits(b),
             a_low = a - a_high, b_low = b - b_high;
  return {product, ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low};
}

inline Twofold<double> exact_product(double a, double b) {
  const Twofold<Pair> product = exact_product(Pair{a, 0.0}, Pair{b, 0.0});
  return {product.value[0], product.low[0]};
}

template <class Number>
Twofold<Number> operator+(const Twofold<Number> &a, Number b) {
  const Twofold<Number> sum = exact_sum(a.value, b);
  return exact_sum(sum.value, sum.low + a.low);
}

// offset + sum_j a_j (b_j + b_low_j), as if in twice the precision.
inline double dot_twofold(double offset, const PerCoordinate &a, const PerCoordinate &b,
                          const PerCoordinate &b_low) {
  Twofold<Pair> total{{offset, 0.0}, {}};
  for (Eigen::Index j = 0; j < b.size(); j += 2) {
    const Pair weight = pair(a.data() + j);
    const Twofold<Pair> term = exact_product(weight, pair(b.data() + j)),
                        next = exact_sum(total.value, term.value);
    total.value = next.value;
    total.low += next.low + term.low + weight * pair(b_low.data() + j);
  }
  const Twofold<double> both = exact_sum(total.value[0], total.value[1]);
  return both.value + (both.low + sum(total.low));
}

}  // namespace vibro_impact::detail
