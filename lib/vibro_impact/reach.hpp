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

// A gap farther from zero than it moves within `time` at speeds within these bounds.
template <int D>
bool out_of_reach(double gap, const OpenStop<D> &open, const Eigen::Array<double, D, 1> &value,
                  const Eigen::Array<double, D, 1> &speeds, double time) {
  return gap > 2.0 * wide_gap(open, value) + reach_of_gap(open.gap, speeds, time);
}

// Sets a gap wider than `margin` wide ones from the lanes. False for others, which are carried from
// event to event.
template <int D>
bool refresh(State<D> &state, const OpenStop<D> &open, double margin = 1.0) {
  const double gap = open.gap(state.value, state.slope);
  if (!(gap > margin * wide_gap(open, state.value))) return false;
  state.stops[open.stop] = {gap, (open.gap.on_value * state.slope).sum(), 0, 0.0};
  return true;
}

// A gap and its speed as they are carried where it is not.
inline StopState carried(const OscillatorState<double> &gap, double span) {
  return {std::max(0.0, gap.value), gap.slope / span, 0, 0.0};
}

// With impacts to come of which the jumps add up to no more than `jumps`; `push` is the largest
// modulus of what a unit jump of the gap speed adds to the slope of every lane. (Decays jump in
// value too, but displacements do not, and no decay is ever faster than at first.)
template <int D>
Eigen::Array<double, D, 1> speed_bounds(const State<D> &state,
                                        const Eigen::Array<double, D, 1> &push, double jumps,
                                        double time) {
  return speed_bounds(*state.mode, state.value, state.slope, time) + jumps * push;
}

// True when a gap is certain to stay positive for `time`, of speeds within these bounds.
template <int D>
bool stays_clear(const State<D> &state, const OpenStop<D> &open,
                 const Eigen::Array<double, D, 1> &speeds, double time) {
  return out_of_reach(open.gap(state.value, state.slope), open, state.value, speeds, time);
}

// The same of a hold force, which every impact makes jump.
template <int D>
bool stays_clear(const State<D> &state, const ClosedStop<D> &closed,
                 const Eigen::Array<double, D, 1> &push, double jumps,
                 const Eigen::Array<double, D, 1> &speeds, double time) {
  const Reading<D> &press = closed.press;
  const double pushed = (press.on_slope.abs() * push).sum();
  const double size = std::abs(press.offset) + (press.on_value * state.value).abs().sum() +
                      (press.on_slope * state.slope).abs().sum();
  return press(state.value, state.slope) >
         0x1p-30 * size + jumps * pushed + reach_of(*state.mode, press, speeds, time);
}

}  // namespace vibro_impact
