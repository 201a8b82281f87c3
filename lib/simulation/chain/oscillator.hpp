// One oscillator in closed form: y'' + kappa y' + lambda y = 0, and forced over a short time.
// The formulas of the free motion hold for under-, critically and over-damped modes and pass
// smoothly from one to the other. The paper prints the under-damped case only.
#pragma once

#include <complex>

namespace vibro_impact::detail {

// y and y' of an oscillator.
struct OscillatorState {
  double value, slope;
};

// The solution after tau of y'' + kappa y' + lambda y = 0 from `start`; kappa, lambda >= 0.
OscillatorState free_response(double kappa, double lambda, OscillatorState start, double tau);

// The change after tau, of at most two radians, of y'' + kappa y' + lambda y = Re(F(t)) + constant,
// F turning from `force` on: the Taylor series, whose terms fall from the start, adds up changes
// that are as accurate as they are small.
OscillatorState change_by_series(double kappa, double lambda, OscillatorState start,
                                 std::complex<double> force, double constant, double omega,
                                 double tau);

}  // namespace vibro_impact::detail
