// The parts of the program by hand: the numbers of its Taylor series, and the limit of a chatter.
#pragma once

#include <array>
#include <cmath>
#include <vector>

namespace vibro_impact::comparison::hand {

// A number for each mass, in one register.
using Pair = double __attribute__((vector_size(16)));

inline Pair swapped(Pair p) {
  return Pair{p[1], p[0]};
}

constexpr std::size_t highest_order = 36;
constexpr double longest_step = 2.0;
constexpr double longest_part = 0.5;  // between two looks at the guards

// Numbers that depend on the order only.
struct Orders {
  std::array<double, highest_order> inverse = {};  // 1 / ((n + 1) (n + 2))
  std::array<double, highest_order> reach = {};    // the longest step of a series of n terms

  // The terms of a motion with frequencies up to one fall below rounding where h^n / n! < 1e-17.
  Orders() {
    double factorial = 1.0;
    for (std::size_t n = 0; n < highest_order; ++n) {
      const auto m = static_cast<double>(n);
      inverse[n] = 1.0 / ((m + 1.0) * (m + 2.0));
      if (n > 0) factorial *= m;
      reach[n] = n > 3 ? std::pow(1e-17 * factorial, 1.0 / m) : 0.0;
    }
  }
};
inline const Orders orders;

// The value at tau of a polynomial with the coefficients c(0) ... c(order), and its derivative. The
// sums of the even and of the odd powers do not wait for each other.
template <class Number>
struct ValueAndSlope {
  Number value, slope;
};
template <class Number, class Coefficient>
ValueAndSlope<Number> polynomial(const Coefficient &c, std::size_t order, double tau) {
  const double square = tau * tau;
  Number even{}, odd{}, even_slope{}, odd_slope{};  // the slopes are those in the square of tau
  for (std::size_t k = order / 2 + 1; k-- > 0;) {
    even_slope = even_slope * square + even;
    even = even * square + c(2 * k);
    odd_slope = odd_slope * square + odd;
    if (2 * k < order) odd = odd * square + c(2 * k + 1);
  }
  return {even + odd * tau, odd + (even_slope + odd_slope * tau) * (2.0 * tau)};
}

// The limit of a sequence whose error is a sum of powers of r^k, k the number of the impact. The
// weights of order m are the coefficients of the product over j = 1 ... m of (z - r^j) / (1 - r^j).
constexpr std::size_t highest_power = 10;
struct Weights {
  std::array<std::array<double, highest_power + 1>, highest_power + 1> of_order = {};

  explicit Weights(double restitution) {
    of_order[0][0] = 1.0;
    double power = 1.0;
    for (std::size_t m = 1; m <= highest_power; ++m) {
      power *= restitution;
      for (std::size_t k = 0; k <= m; ++k)
        of_order[m][k] =
            ((k > 0 ? of_order[m - 1][k - 1] : 0.0) - power * of_order[m - 1][k]) / (1.0 - power);
    }
  }
};

// The impacts of a mass since the last other event: the time since the first one, and the gap and
// the gap speed of the other mass.
struct Chatter {
  using Node = std::array<double, 3>;
  std::vector<Node> nodes = {};
  double begin = 0.0;

  double limit(const Weights &weights, std::size_t order, std::size_t number) const {
    double sum = 0.0;
    for (std::size_t k = 0; k <= order; ++k)
      sum += weights.of_order[order][k] * nodes[nodes.size() - 1 - order + k][number];
    return sum;
  }
};

}  // namespace vibro_impact::comparison::hand
