// Numbers of twice the precision of a double: unevaluated sums hi + lo with |lo| below the rounding
// of hi (Knuth; Dekker). One is a `Real`; two side by side in one vector register are a `RealPair`,
// with the same operators.
//
// Sums and products err by at most 16 units, 2^-102, of the sum of the moduli of their terms, not
// of the result: terms may cancel. Every decision of the simulation is relative to these moduli.
#pragma once

#ifdef __FAST_MATH__
#error "-ffast-math removes the rounding errors that numbers of twice the precision consist of"
#endif

#include <bit>
#include <cmath>
#include <compare>
#include <cstdint>
#include <cstring>

namespace vibro_impact::detail {

// A unit in the last place of a number next to 1.
constexpr double twofold_unit = 0x1p-106;

using Pair [[gnu::vector_size(16)]] = double;

inline Pair pair(const double *two) {
  Pair result;
  std::memcpy(&result, two, sizeof result);
  return result;
}

inline void put(Pair two, double *to) {
  std::memcpy(to, &two, sizeof two);
}

// The two numbers in the other order.
inline Pair exchanged(Pair two) {
  return __builtin_shufflevector(two, two, 1, 0);
}

// The second of the first two, and the first of the last two.
inline Pair middle(Pair first, Pair last) {
  return __builtin_shufflevector(first, last, 1, 2);
}

inline Pair modulus(Pair two) {
  using Bits [[gnu::vector_size(16)]] = long long;
  constexpr long long mask = ~(1LL << 63);
  return std::bit_cast<Pair>(std::bit_cast<Bits>(two) & Bits{mask, mask});
}

// A number rounded to its leading 26 bits. The other bits fit into 26 bits and a sign, so that all
// products of such halves are exact.
inline double leading_bits(double a) {
  return std::bit_cast<double>((std::bit_cast<std::uint64_t>(a) + 0x4000000u) &
                               ~std::uint64_t{0x7ffffff});
}

inline Pair leading_bits(Pair a) {
  using Bits [[gnu::vector_size(16)]] = long long;
  constexpr long long half = 0x4000000LL, mask = ~0x7ffffffLL;
  return std::bit_cast<Pair>((std::bit_cast<Bits>(a) + Bits{half, half}) & Bits{mask, mask});
}

// The largest power of two up to a positive normal number.
inline double leading_power(double a) {
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(a) & 0x7ff0000000000000u);
}

template <class T>
struct Twofold {
  T hi{}, lo{};

  constexpr Twofold() = default;
  constexpr Twofold(T value) : hi(value) {
  }
  constexpr Twofold(T high, T low) : hi(high), lo(low) {
  }

  // a + b without rounding, if |a| >= |b|.
  static Twofold quick_sum(T a, T b) {
    const T sum = a + b;
    return {sum, b - (sum - a)};
  }
  // a + b without rounding.
  static Twofold exact_sum(T a, T b) {
    const T sum = a + b, added = sum - a;
    return {sum, (a - (sum - added)) + (b - added)};
  }
  // a b without rounding. A fused operation gives the same bits.
  static Twofold exact_product(T a, T b) {
    const T product = a * b;
#ifdef __FMA__
    if constexpr (sizeof(T) == sizeof(double))
      return {product, std::fma(a, b, -product)};
    else
      return {product, T{std::fma(a[0], b[0], -product[0]), std::fma(a[1], b[1], -product[1])}};
#else
    const T ah = leading_bits(a), bh = leading_bits(b), al = a - ah, bl = b - bh;
    return {product, ((ah * bh - product) + ah * bl + al * bh) + al * bl};
#endif
  }

  friend Twofold operator+(const Twofold &a, const Twofold &b) {
    const Twofold s = exact_sum(a.hi, b.hi);
    return quick_sum(s.hi, s.lo + (a.lo + b.lo));
  }
  friend Twofold operator+(const Twofold &a, T b) {
    const Twofold s = exact_sum(a.hi, b);
    return quick_sum(s.hi, s.lo + a.lo);
  }
  friend Twofold operator+(T a, const Twofold &b) {
    return b + a;
  }
  friend Twofold operator-(const Twofold &a) {
    return {-a.hi, -a.lo};
  }
  friend Twofold operator-(const Twofold &a, const Twofold &b) {
    return a + -b;
  }
  friend Twofold operator-(const Twofold &a, T b) {
    return a + -b;
  }
  friend Twofold operator-(T a, const Twofold &b) {
    return -b + a;
  }
  friend Twofold operator*(const Twofold &a, const Twofold &b) {
    const Twofold p = exact_product(a.hi, b.hi);
    return quick_sum(p.hi, p.lo + (a.hi * b.lo + a.lo * b.hi));
  }
  friend Twofold operator*(const Twofold &a, T b) {
    const Twofold p = exact_product(a.hi, b);
    return quick_sum(p.hi, p.lo + a.lo * b);
  }
  friend Twofold operator*(T a, const Twofold &b) {
    return b * a;
  }
  // Three digits of a long division.
  friend Twofold operator/(const Twofold &a, const Twofold &b) {
    const T first = a.hi / b.hi;
    const Twofold rest = a - b * first;
    const T second = rest.hi / b.hi, third = (rest - b * second).hi / b.hi;
    return quick_sum(first, second) + third;
  }
  template <class Other>
  Twofold &operator+=(const Other &b) {
    return *this = *this + b;
  }
  template <class Other>
  Twofold &operator-=(const Other &b) {
    return *this = *this - b;
  }
  template <class Other>
  Twofold &operator*=(const Other &b) {
    return *this = *this * b;
  }
  friend auto operator<=>(const Twofold &, const Twofold &) = default;
};

using Real = Twofold<double>;
using RealPair = Twofold<Pair>;

inline RealPair load(const Real *two) {
  return {Pair{two[0].hi, two[1].hi}, Pair{two[0].lo, two[1].lo}};
}
inline void store(const RealPair &two, Real *to) {
  to[0] = {two.hi[0], two.lo[0]};
  to[1] = {two.hi[1], two.lo[1]};
}
inline RealPair middle(const RealPair &first, const RealPair &last) {
  return {middle(first.hi, last.hi), middle(first.lo, last.lo)};
}
// A product with a power of two or its opposite, which is exact.
inline Real scaled(const Real &a, double power) {
  return {a.hi * power, a.lo * power};
}

inline RealPair both(const Real &a) {
  return {Pair{a.hi, a.hi}, Pair{a.lo, a.lo}};
}

// The number as a double: formulas serve both precisions.
inline double rounded(double x) {
  return x;
}
inline double rounded(const Real &x) {
  return x.hi;
}

inline Real abs(const Real &x) {
  return x.hi < 0.0 ? -x : x;
}
Real sqrt(const Real &x);
Real exp(const Real &x);
// |x| up to 1e15.
void sincos(const Real &x, Real &sine, Real &cosine);
// cos w - 1 and sin w - w, for |w| up to 3, to a few roundings.
Pair higher_orders_of_turn(double w);
inline void sincos(double x, double &sine, double &cosine) {
  sine = std::sin(x);
  cosine = std::cos(x);
}

}  // namespace vibro_impact::detail
