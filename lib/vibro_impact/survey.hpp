// What a gap or a hold force does over the longest span, before any polynomial of it is set up:
// from its Bernstein coefficients.
//
// On [0, 1] a polynomial is a convex combination of its Bernstein coefficients, and has at most as
// many roots as they have changes of sign. They are linear in the lanes, like the Taylor
// coefficients, with weights that are set up with those (`build_series`) for the terms up to a low
// degree; the others amount to no more than the last of those powers times a sum over the lanes.
#pragma once

#include <algorithm>

#include "expansion.hpp"

namespace vibro_impact {

enum class Outlook { stays_positive, crosses_once, undecided };

struct Survey {
  Outlook outlook = Outlook::undecided;
  double crossing = 0.0;  // near the root, in units of the longest span
  double cut_off = 0.0;   // how far off the Bernstein polynomial may be
};

namespace detail {

// In whole packets, also from the second on.
using Bernstein = std::array<double, bernstein_degree + 5>;

// Where a polynomial that falls through zero once does so, nearly: a step of third order from where
// its control polygon does, which is between the coefficients before and `after`, the first
// negative one.
inline double crossing_of(const Bernstein &b, std::size_t after) {
  static_assert(bernstein_degree == 11);
  constexpr double d = 11.0;
  const double u = (static_cast<double>(after - 1) + b[after - 1] / (b[after - 1] - b[after])) / d;
  // Its last three de Casteljau coefficients there, of which those of degree d - 2 are the weights.
  const double v = 1.0 - u, u4 = u * u * u * u, v2 = v * v;
  const Four up = four_powers(u), down = four_powers(v).reverse();
  const std::array<Four, 3> basis{
      Four(1.0, 9.0, 36.0, 84.0) * up * down * (v2 * v2 * v2),
      Four(126.0, 126.0, 84.0, 36.0) * up * down * (u4 * v2),
      Four(9.0, 1.0, 0.0, 0.0) * up * Four(v, 1.0, 0.0, 0.0) * (u4 * u4)};
  const auto last = [&](const double *c) {
    return (basis[0] * four(c) + basis[1] * four(c + 4) + basis[2] * four(c + 8)).sum();
  };
  const double first = last(b.data()), second = last(b.data() + 1), third = last(b.data() + 2);
  const double left = second - first, bend = third - second - left;
  const double slope = d * (left + u * bend), value = first + u * (2.0 * left + u * bend);
  const double newton = -value / slope, a = -0.5 * d * (d - 1.0) * bend / slope * newton;
  return u + newton * (1.0 + a * (1.0 + 2.0 * a));
}

}  // namespace detail

// Surveys a reading of which the first `known` coefficients are zero but for the last of them,
// which is positive.
template <int D>
Survey survey(const ContactMode<D> &mode, const Reading<D> &reading,
              const Eigen::Array<double, D, 1> &value, const Eigen::Array<double, D, 1> &slope,
              const Expansion &expansion, std::size_t known, Counters &counters) {
  using detail::Four;
  const Eigen::Index lanes = mode.lanes(), modal = mode.modal_lanes();
  const ReadingSeries &series = series_of(mode, reading, expansion);
  detail::Bernstein b{};
  const double *weight = series.bernstein.data();
  for (std::size_t i = 0; i <= bernstein_degree; i += 4) {
    Eigen::Map<Four>(b.data() + i) = reading.offset + detail::weigh(mode, weight, value, slope);
    weight += 4 * (lanes + modal);
  }
  Survey seen;
  seen.cut_off = 0x1p-44 * std::abs(reading.offset);
  for (Eigen::Index k = 0; k < lanes; ++k) seen.cut_off += series.cut_off(k) * std::abs(value(k));
  for (Eigen::Index k = 0; k < modal; ++k)
    seen.cut_off += series.cut_off(lanes + k) * std::abs(slope(k));
  counters.products += static_cast<long long>(bernstein_degree + 1) * (lanes + modal);

  std::size_t i = known;
  while (i <= bernstein_degree && b[i] > seen.cut_off) ++i;
  if (i > bernstein_degree) {
    seen.outlook = Outlook::stays_positive;
    return seen;
  }
  const std::size_t after = i;
  while (i <= bernstein_degree && b[i] < -seen.cut_off) ++i;
  if (i <= bernstein_degree || after == 0) return seen;
  seen.outlook = Outlook::crosses_once;
  seen.crossing = std::clamp(detail::crossing_of(b, after), 0.0, 1.0);
  return seen;
}

}  // namespace vibro_impact
