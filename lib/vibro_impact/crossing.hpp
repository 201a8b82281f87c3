// The root of a gap or a hold force that crosses zero once in a long flight: found on the lanes
// themselves, without a polynomial.
#pragma once

#include "first_root.hpp"
#include "motion.hpp"
#include "survey.hpp"

namespace vibro_impact {

// The lanes at a crossing, `u` of the expansion later, and the slope of the reading there, per unit
// of time.
template <int D>
struct Crossing {
  Eigen::Array<double, D, 1> value, slope;
  double u = 0.0, rate = 0.0;
};

namespace detail {

// y, y', ..., y^(5) of every lane.
template <int D>
using Derivatives = std::array<Eigen::Array<double, D, 1>, 6>;

template <int D>
Derivatives<D> derivatives_of(const ContactMode<D> &mode, const Eigen::Array<double, D, 1> &value,
                              const Eigen::Array<double, D, 1> &slope) {
  Derivatives<D> y{value, slope};
  for (std::size_t k = 2; k < y.size(); ++k) y[k] = -mode.kappa * y[k - 1] - mode.lambda * y[k - 2];
  return y;
}

// A bound, from here on, of derivative k of a reading: y^(k - 1) obeys the equation of y, of which
// the slope never exceeds |y'| + rate |y|.
template <int D>
double bound_of_derivative(const ContactMode<D> &mode, const Reading<D> &reading,
                           const Derivatives<D> &y, std::size_t k) {
  return ((reading.on_value.abs() + mode.rate * reading.on_slope.abs()) *
          (y[k].abs() + mode.rate * y[k - 1].abs()))
      .sum();
}

template <int D>
Jet jet_of(const Reading<D> &reading, const Derivatives<D> &y) {
  const auto derivative = [&](std::size_t k) {
    return (reading.on_value * y[k] + reading.on_slope * y[k + 1]).sum();
  };
  return {reading.offset + derivative(0), derivative(1), derivative(2) / 2.0, derivative(3) / 6.0,
          derivative(4) / 24.0};
}

}  // namespace detail

// Finds the crossing seen by a survey, over the longest span; not for lanes in resonance. False
// where it is not certain to be the first root, as near a tangency.
template <int D>
bool find_crossing(const State<D> &state, const Reading<D> &reading, const Survey &seen,
                   const Expansion &expansion, const Scene &scene, const Clock &clock,
                   Crossing<D> &crossing, Counters &counters) {
  const ContactMode<D> &mode = *state.mode;
  const double bend = detail::bound_of_derivative(
      mode, reading, detail::derivatives_of(mode, state.value, state.slope), 2);
  double time = seen.crossing * expansion.span;
  for (int step = 0; step < 4; ++step) {
    ++counters.root_iterations;
    crossing.value = state.value;
    crossing.slope = state.slope;
    advance(mode, expansion, time / expansion.span, crossing.value, crossing.slope);
    set_forcing(mode, scene, later(state.now, time, clock).phase, crossing.value, crossing.slope);
    const detail::Derivatives<D> y = detail::derivatives_of(mode, crossing.value, crossing.slope);
    const Jet at = detail::jet_of(reading, y);
    const double square = at.slope * at.slope, off = std::abs(at.value);
    // Kantorovich, as in `first_root`: the slope varies by less than half of itself over twice the
    // distance at which the root of this reading or of its Bernstein polynomial may lie.
    if (!(at.slope < 0.0 && bend * (off + 2.0 * seen.cut_off) <= 0.25 * square)) return false;
    const double fifth = detail::bound_of_derivative(mode, reading, y, 5) / 120.0;
    const detail::SeriesStep to = detail::series_step(at, bend * off / square, fifth);
    const double moved = expansion.rate * std::abs(to.step);
    if (moved <= 1e-3 && to.error * moved <= 0x1p-56) {
      const double d = to.step;
      crossing.u = (time + d) / expansion.span;
      if (!(crossing.u > 0.0 && crossing.u <= 1.0)) return false;
      crossing.value = y[0] + d * (y[1] + d / 2 * (y[2] + d / 3 * (y[3] + d / 4 * y[4])));
      crossing.slope = y[1] + d * (y[2] + d / 2 * (y[3] + d / 3 * (y[4] + d / 4 * y[5])));
      crossing.rate =
          rate_of(reading, crossing.slope, curvature_of(mode, crossing.value, crossing.slope));
      return true;
    }
    time = std::clamp(time + to.step, 0.0, expansion.span);
  }
  return false;
}

}  // namespace vibro_impact
