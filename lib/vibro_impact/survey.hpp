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

using Bernstein = std::array<double, bernstein_degree + 1>;

// Where a polynomial that falls through zero once does so, nearly. Its value at i / d is its i-th
// coefficient and d / 2 u (1 - u) times the second difference there, up to O(d^-2); in between it
// is taken for a parabola. `after` is the first negative coefficient.
inline double crossing_of(const Bernstein &b, std::size_t after) {
  constexpr std::size_t last = bernstein_degree;
  constexpr auto d = static_cast<double>(last);
  const auto bend_at = [&](std::size_t i) {
    const std::size_t k = std::clamp<std::size_t>(i, 1, last - 1);
    return b[k + 1] - 2.0 * b[k] + b[k - 1];
  };
  const auto value_at = [&](std::size_t i) {
    const double u = static_cast<double>(i) / d;
    return b[i] + 0.5 * d * u * (1.0 - u) * bend_at(i);
  };
  double below = value_at(after), above = value_at(after - 1);
  while (below > 0.0 && after < last) above = below, below = value_at(++after);
  while (above < 0.0 && after > 1) below = above, above = value_at(--after - 1);
  const double f = above / (above - below);
  const double bent = 0.25 * f * (f - 1.0) * (bend_at(after) + bend_at(after - 1));
  return (static_cast<double>(after - 1) + f + bent / (above - below)) / d;
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
  detail::Bernstein b;
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
  seen.crossing = detail::crossing_of(b, after);
  return seen;
}

}  // namespace vibro_impact
