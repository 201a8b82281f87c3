// Taylor expansion of the flow about an event, of nothing but what is looked at.
//
// A gap, a hold force, depends linearly on the lanes, which obey a linear equation: its derivatives
// are linear in the lanes as well, with weights that the adjoint recurrence gives once per contact
// mode. Along a flight a coefficient costs one product with the lanes, and stops that are not
// looked at cost nothing. The variable is scaled, u = tau / span in [0, 1]. `order_for` picks the
// order from the rate of the fastest lane, for a remainder that is small (by default below
// rounding) even relative to the second-order term, which is what keeps the tiny gaps of a late
// chatter accurate.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>

#include "counters.hpp"
#include "motion.hpp"
#include "polynomial.hpp"

namespace vibro_impact {

// What the remainder of an expansion may be, relative to the second-order term, x^2 / 2 with
// x = rate * span; and by order p the largest x at which the first term dropped is no more than
// that: 2 x^(p-1) / (p+1)! <= relative.
struct Remainder {
  double relative;
  std::array<double, max_order + 1> reaches{};

  explicit Remainder(double allowed) : relative(allowed) {
    double factorial = 6.0;  // (p + 1)!
    for (int p = 2; p <= max_order; ++p) {
      reaches[static_cast<std::size_t>(p)] = std::pow(0.5 * relative * factorial, 1.0 / (p - 1));
      factorial *= p + 2;
    }
  }
};

constexpr double flight_rounding = 0x1p-56;
inline const Remainder below_rounding(flight_rounding);

// Smallest order of the form 4 k + 3, one that fills whole packets, whose remainder is tolerable
// over fastest * span = reach.
inline int order_for(double reach, const Remainder &remainder) {
  int order = 3;
  for (int p = 3; p < max_order - 1; p += 4)
    order += reach > remainder.reaches[static_cast<std::size_t>(p)] ? 4 : 0;
  return order;
}

// One stretch of flight: how far, at which rate, to which order; powers of rate * span, known up to
// `powers`.
struct Expansion {
  double span = 0.0, rate = 0.0;
  int order = 0, powers = -1;
  detail::Powers power{};
  const Remainder *remainder = &below_rounding;
};

// The order that does over `time`, of a flight at the rate of this expansion.
inline int order_over(const Expansion &expansion, double time) {
  return order_for(expansion.rate * time, *expansion.remainder);
}

// Opens an expansion of the lanes of `mode` over [0, span].
template <int D>
void expand(const ContactMode<D> &mode, const Eigen::Array<double, D, 1> &value,
            const Eigen::Array<double, D, 1> &slope, double span, Expansion &expansion,
            Counters &counters) {
  const double rate = fastest_in_motion(mode, value, slope), x = rate * span;
  expansion.span = span;
  expansion.rate = rate;
  expansion.order = order_over(expansion, span);
  if (expansion.power[1] != x || expansion.powers < expansion.order) {  // most are the longest
    detail::set_powers(expansion.power, x, expansion.order);
    expansion.powers = expansion.order;
  }
  ++counters.expansions;
  counters.coefficients += expansion.order + 1;
}

// The series of a reading for motion of the rate of this expansion.
template <int D>
const ReadingSeries &series_of(const ContactMode<D> &mode, const Reading<D> &reading,
                               const Expansion &expansion) {
  if (reading.series.rate != expansion.rate) build_series(mode, reading, expansion.rate);
  return reading.series;
}

namespace detail {

// The next four coefficients that are linear in the lanes, of these weights: one column per lane,
// then one per slope of a mode. In line: what it returns is to stay in registers.
template <int D>
[[gnu::always_inline]] inline Four weigh(const ContactMode<D> &mode, const double *weight,
                                         const Eigen::Array<double, D, 1> &value,
                                         const Eigen::Array<double, D, 1> &slope) {
  const Eigen::Index lanes = mode.lanes(), modal = mode.modal_lanes();
  Four even = Four::Zero(), odd = even;  // two chains of sums
  Eigen::Index k = 0;
  for (; k + 1 < lanes; k += 2, weight += 8) {
    even += four(weight) * value(k);
    odd += four(weight + 4) * value(k + 1);
  }
  if (k < lanes) even += four(weight) * value(k), weight += 4;
  for (k = 0; k + 1 < modal; k += 2, weight += 8) {
    even += four(weight) * slope(k);
    odd += four(weight + 4) * slope(k + 1);
  }
  if (k < modal) even += four(weight) * slope(k);
  return even + odd;
}

}  // namespace detail

// Sets `p` to the polynomial of a reading, without its offset, along the expansion of (value,
// slope).
template <int D>
void read_linear_along(const ContactMode<D> &mode, const Reading<D> &reading,
                       const Eigen::Array<double, D, 1> &value,
                       const Eigen::Array<double, D, 1> &slope, const Expansion &expansion,
                       Polynomial &p, Counters &counters) {
  const Eigen::Index lanes = mode.lanes(), modal = mode.modal_lanes();
  const double *weight = series_of(mode, reading, expansion).weight.data();
  using detail::Four, detail::four;
  for (int n = 0; n <= expansion.order; n += 4) {
    const Four sum = detail::weigh(mode, weight, value, slope);
    Eigen::Map<Four>(p.coefficient.data() + n) = sum * four(expansion.power.data() + n);
    weight += 4 * (lanes + modal);
  }
  end_at(p, expansion.order);
  counters.products += (expansion.order + 1) * (lanes + modal);
}

template <int D>
void read_along(const ContactMode<D> &mode, const Reading<D> &reading,
                const Eigen::Array<double, D, 1> &value, const Eigen::Array<double, D, 1> &slope,
                const Expansion &expansion, Polynomial &p, Counters &counters) {
  read_linear_along(mode, reading, value, slope, expansion, p, counters);
  p.coefficient[0] += reading.offset;
}

// Lane j where S and S' have these values. One solution, S with S(0) = 0 and S'(0) = 1, gives all
// others: C = S' + kappa S, C' = -lambda S.
template <int D>
OscillatorState<double> lane_after(const ContactMode<D> &mode, Eigen::Index j, double value,
                                   double slope, const OscillatorState<double> &s) {
  return {value * (s.slope + mode.kappa(j) * s.value) + slope * s.value,
          slope * s.slope - mode.lambda(j) * value * s.value};
}

// The lanes u of the expansion later, those of the forcing excepted.
template <int D>
void advance(const ContactMode<D> &mode, const Expansion &expansion, double u,
             Eigen::Array<double, D, 1> &value, Eigen::Array<double, D, 1> &slope) {
  using detail::Two, detail::two;
  FlowSeries<D> &series = mode.series;
  if (series.rate != expansion.rate) build_flow_series(mode, expansion.rate);
  if (expansion.rate == 0.0) return;  // nothing moves
  const double x = expansion.power[1] * u, w = x * x;
  const Eigen::Index modal = mode.modal_lanes(), stride = series.response.rows();
  const int top = expansion.order | 1;  // odd
  for (Eigen::Index j = 0; j < modal; j += 2) {
    const double *s = series.response.data() + j + top * stride;
    const double *ds = series.rate_of_response.data() + j + top * stride;
    Two even = Two::Zero(), odd = even, even_slope = even, odd_slope = even;
    for (int n = top; n > 0; n -= 2, s -= 2 * stride, ds -= 2 * stride) {
      odd = odd * w + two(s);
      even = even * w + two(s - stride);
      odd_slope = odd_slope * w + two(ds);
      even_slope = even_slope * w + two(ds - stride);
    }
    const Two response = even + x * odd, rate = even_slope + x * odd_slope;
    for (Eigen::Index i = j; i < std::min(modal, j + 2); ++i) {
      const auto after = lane_after(mode, i, value(i), slope(i), {response(i - j), rate(i - j)});
      value(i) = after.value;
      slope(i) = after.slope;
    }
  }
}

}  // namespace vibro_impact
