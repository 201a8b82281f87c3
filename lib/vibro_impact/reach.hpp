// How far the lanes can carry a gap or a hold force within a time, without a polynomial of it: what
// is farther from zero than that need not be looked at.
//
// No lane moves faster than |y'| + rate |y|, for y'^2 + lambda y^2 never grows and lambda <=
// rate^2; and |y''| = |kappa y' + lambda y| is at most three times rate times that. A lane in
// resonance, on which the forcing works, gains what the force does in the time.
#pragma once

#include "motion.hpp"

namespace vibro_impact {

// Bounds of the speeds of the lanes for `time`.
template <int D>
Eigen::Array<double, D, 1> speed_bounds(const ContactMode<D> &mode,
                                        const Eigen::Array<double, D, 1> &value,
                                        const Eigen::Array<double, D, 1> &slope, double time) {
  Eigen::Array<double, D, 1> speeds = slope.abs() + mode.rate * value.abs();
  if (mode.any_resonant) speeds += time * mode.resonant.abs();
  return speeds;
}

// How far a reading without y', a gap, moves within `time`.
template <int D>
double reach_of_gap(const Reading<D> &gap, const Eigen::Array<double, D, 1> &speeds, double time) {
  return (1.0 + 0x1p-9) * time * (gap.on_value.abs() * speeds).sum();
}

// How far any reading moves.
template <int D>
double reach_of(const ContactMode<D> &mode, const Reading<D> &reading,
                const Eigen::Array<double, D, 1> &speeds, double time) {
  double rate =
      ((reading.on_value.abs() + 3.0 * mode.rate * reading.on_slope.abs()) * speeds).sum();
  if (mode.any_resonant) rate += (reading.on_slope * mode.resonant).abs().sum();
  return (1.0 + 0x1p-9) * time * rate;
}

// A wide gap is known from the lanes with less than ten bits lost to cancellation.
template <int D>
double wide_gap(const OpenStop<D> &open, const Eigen::Array<double, D, 1> &value) {
  return 0x1p-10 * (std::abs(open.gap.offset) + (open.gap.on_value * value).abs().sum());
}

}  // namespace vibro_impact
