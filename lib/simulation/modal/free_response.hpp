// The free motion of one mode, in double precision.
#pragma once

#include "oscillator.hpp"

namespace vibro_impact::detail {

// y and y' of an oscillator.
struct OscillatorState {
  double value, slope;
};

// The solution after tau of y'' + kappa y' + lambda y = 0 from `start`; kappa, lambda >= 0.
inline OscillatorState free_response(double kappa, double lambda, OscillatorState start,
                                     double tau) {
  const auto [h, dh] = impulse_response(Oscillator<double>(lambda, kappa), tau);
  return {start.value * (dh + kappa * h) + start.slope * h,
          start.slope * dh - lambda * start.value * h};
}

}  // namespace vibro_impact::detail
