// DOP853, the Runge-Kutta method of order 8(5,3) with dense output of order 7 of E. Hairer,
// S. P. Norsett and G. Wanner (Solving Ordinary Differential Equations I, Sections II.5 and II.6).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#include "event_loop.hpp"

namespace vibro_impact::comparison::dop {

// Twelve stages, the slope at the end of the step, and three for the dense output.
constexpr int stages = 16;
using Matrix = std::array<std::array<double, stages>, stages>;

constexpr Matrix matrix(std::string_view name) {
  struct Entry {
    std::string_view matrix;
    std::size_t row, column;
    double value;
  };
  constexpr Entry entries[] = {
#include "dop853.inc"
  };
  Matrix all{};
  for (const Entry &entry : entries)
    if (entry.matrix == name) all[entry.row][entry.column] = entry.value;
  return all;
}
inline constexpr Matrix A = matrix("A"), C = matrix("C"), D = matrix("D"), E3 = matrix("E3"),
                        E5 = matrix("E5");

// The sum over the stages j of m[row][j] slope(j), without the terms that are zero.
template <const Matrix &m, std::size_t row, class Slope>
auto sum(const Slope &slope) {
  decltype(slope(0)) total = 0;
  const auto add = [&]<std::size_t j>() {
    if constexpr (m[row][j] != 0.0) total += m[row][j] * slope(j);
  };
  [&]<std::size_t... j>(std::index_sequence<j...>) {
    (add.template operator()<j>(), ...);
  }
  (std::make_index_sequence<stages>());
  return total;
}

// The change of a coordinate with the slopes slope(j) after the part theta of a step of length one:
// theta (f_0 + (1 - theta) (f_1 + theta (f_2 + (1 - theta) (f_3 + ...)))).
template <class Slope>
auto dense_output(const Slope &slope) {
  const auto change = sum<A, 12>(slope);
  return std::array{change,           slope(0) - change, 2 * change - slope(0) - slope(12),
                    sum<D, 0>(slope), sum<D, 1>(slope),  sum<D, 2>(slope),
                    sum<D, 3>(slope)};
}
template <class Real>
Real change_after(Real theta, const std::array<Real, 7> &f) {
  Real value = 0;
  for (std::size_t i = f.size(); i-- > 0;) value = (value + f[i]) * (i % 2 ? 1 - theta : theta);
  return value;
}

// The method with the error control of its authors, for `advance`. system(y, dydt, tau) is the
// right-hand side, and system.now.y the state at the last event. `tolerance` is absolute and
// relative.
template <class State, class System>
struct Steps {
  using Real = typename State::value_type;

  System system;
  Real tolerance;
  State y_from, y_to = y_from;
  std::vector<Real> slopes = std::vector<Real>(stages * y_from.size());  // one stage after another
  std::vector<Real> dense = std::vector<Real>(7 * y_from.size());
  bool has_dense = false, restarted = true;
  double from = 0.0, to = 0.0, step = 0.0;
  StepLength length = {};

  void restart(double longest_first) {
    y_to = system.now.y;
    to = 0.0;
    step = length.first(longest_first);
    restarted = true;
  }

  auto slopes_of(std::size_t n) const {
    return [first = slopes.data() + n, size = y_from.size()](std::size_t j) {
      return first[j * size];
    };
  }
  Real *slopes_at(std::size_t stage) {
    return slopes.data() + stage * y_from.size();
  }

  // y_from plus the step times the sum of the row of A.
  template <std::size_t row>
  void add_slopes(State &y) const {
    const Real h = to - from;
    const Real *const start = y_from.data(), *const slope = slopes.data();
    Real *const end = y.data();
    const std::size_t size = y.size();
    for (std::size_t n = 0; n < size; ++n)
      end[n] = start[n] + h * sum<A, row>([&](std::size_t j) { return slope[j * size + n]; });
  }

  // The slopes of the stages first + k, whose arguments are left in y.
  template <std::size_t first, std::size_t... k>
  void evaluate(State &y, std::index_sequence<k...>) {
    const auto stage = [&]<std::size_t i>() {
      add_slopes<i>(y);
      system(y, slopes_at(i), from + C[0][i] * (to - from));
    };
    (stage.template operator()<first + k>(), ...);
  }

  // The estimate of order 7 made from those of order 5 and 3, relative to the tolerance.
  Real error() const {
    Real fifth = 0, third = 0;
    for (std::size_t n = 0; n < y_to.size(); ++n) {
      const Real scale = tolerance + tolerance * std::max(std::abs(y_from[n]), std::abs(y_to[n]));
      const Real of_five = sum<E5, 0>(slopes_of(n)) / scale,
                 of_three = sum<E3, 0>(slopes_of(n)) / scale;
      fifth += of_five * of_five;
      third += of_three * of_three;
    }
    const Real both = fifth + third / 100;
    if (both == 0) return 0;
    return (to - from) * fifth / std::sqrt(both * static_cast<Real>(y_to.size()));
  }

  std::pair<double, double> next() {
    y_from = y_to;
    from = to;
    has_dense = false;
    if (restarted)
      system(y_from, slopes_at(0), from);
    else
      std::copy_n(slopes_at(12), y_from.size(), slopes_at(0));
    restarted = false;
    double factor = 0.0;
    for (bool accepted = false; !accepted;) {
      if (!(step > std::numeric_limits<double>::min()))
        throw std::runtime_error("the length of a step vanishes");
      to = from + step;
      evaluate<1>(y_to, std::make_index_sequence<11>());
      add_slopes<12>(y_to);
      const auto ratio = static_cast<double>(error());
      accepted = ratio <= 1.0;
      factor = std::clamp(0.9 * std::pow(ratio, -1.0 / 8.0), 1.0 / 3.0, 6.0);
      step *= accepted ? 1.0 : factor;
    }
    system(y_to, slopes_at(12), to);
    length.chosen(step * factor);
    step = length.usual;
    return {from, to};
  }

  // The coordinates at a time within the step. The dense output takes three more stages when it is
  // first asked for.
  struct View {
    const Steps &steps;
    double tau;

    Real operator[](std::size_t n) const {
      if (tau == steps.from) return steps.y_from[n];
      if (tau == steps.to) return steps.y_to[n];
      const Real h = steps.to - steps.from;
      std::array<Real, 7> f;
      for (std::size_t i = 0; i < f.size(); ++i) f[i] = steps.dense[i * steps.y_from.size() + n];
      return steps.y_from[n] + h * change_after((tau - steps.from) / h, f);
    }
    operator State() const {
      State y = steps.y_from;
      for (std::size_t n = 0; n < y.size(); ++n) y[n] = (*this)[n];
      return y;
    }
  };
  View at(double tau) {
    if (!has_dense && tau != from && tau != to) {
      State y = y_from;
      evaluate<13>(y, std::make_index_sequence<3>());
      for (std::size_t n = 0; n < y.size(); ++n) {
        const auto f = dense_output(slopes_of(n));
        for (std::size_t i = 0; i < f.size(); ++i) dense[i * y.size() + n] = f[i];
      }
      has_dense = true;
    }
    return {*this, tau};
  }
};

}  // namespace vibro_impact::comparison::dop
