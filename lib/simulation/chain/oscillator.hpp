// One oscillator in closed form: y'' + kappa y' + lambda y = 0, and forced where the response
// cannot be split off. The formulas hold for under-, critically and over-damped modes and pass
// smoothly from one to the other; the paper prints the under-damped case only.
#pragma once

#include <complex>

namespace vibro_impact::detail {

// One oscillator's value and time derivative.
struct OscillatorState {
  double value, slope;
};

// Solution after tau of y'' + kappa y' + lambda y = 0 from (value, slope); kappa, lambda >= 0.
OscillatorState free_response(double kappa, double lambda, OscillatorState start, double tau);

// Response from rest after tau of y'' + kappa y' + lambda y = Re(F(t)), F turning at the rate omega
// from `force` to `force_after`, for an under-damped mode at or near resonance: difference
// quotients instead of a steady response that grows without bound there. However long tau is, the
// phase of the forcing is not rounded with it.
OscillatorState forced_from_rest(double kappa, double lambda, std::complex<double> force,
                                 std::complex<double> force_after, double omega, double tau);

// The same for lambda = kappa = 0, the rigid-body mode of a free chain; omega = 0 is a fall.
OscillatorState forced_drift(std::complex<double> force, std::complex<double> force_after,
                             double omega, double tau);

// The change after tau, of at most two radians, of y'' + kappa y' + lambda y = Re(F(t)) + constant,
// F turning from `force` on: the Taylor series, whose terms fall from the start, adds up changes
// that are as accurate as they are small.
OscillatorState change_by_series(double kappa, double lambda, OscillatorState start,
                                 std::complex<double> force, double constant, double omega,
                                 double tau);

}  // namespace vibro_impact::detail
