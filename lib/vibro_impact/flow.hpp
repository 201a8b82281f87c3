// The exact flow of one contact mode, in closed form.
//
// A contact mode is carried as `lanes`: independent oscillators y'' + kappa y' + lambda y = 0, one
// per free mode of Eq. 7 (its deviation from the steady response) and two for the forcing itself,
// cos(Omega t) and sin(Omega t). The closed form holds for under-, critically and over-damped modes
// and passes smoothly from one to the other; the paper prints the under-damped case only.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <complex>

namespace vibro_impact {

// One oscillator's value and time derivative.
template <class Scalar>
struct OscillatorState {
  Scalar value, slope;
};

// Solution after tau of y'' + kappa y' + lambda y = 0 from (value, slope); kappa, lambda >= 0.
template <class Scalar>
OscillatorState<Scalar> free_response(Scalar kappa, Scalar lambda, OscillatorState<Scalar> start,
                                      Scalar tau) {
  using std::cos, std::exp, std::expm1, std::sin, std::sqrt;
  const Scalar alpha = kappa / 2, discriminant = alpha * alpha - lambda;
  if (discriminant < 0) {
    const Scalar omega = sqrt(-discriminant), decay = exp(-alpha * tau);
    const Scalar c = cos(omega * tau), s = sin(omega * tau) / omega;
    return {decay * (start.value * (c + alpha * s) + start.slope * s),
            decay * (start.slope * (c - alpha * s) - lambda * start.value * s)};
  }
  // Roots -slow and -(slow + 2 delta); slow = alpha - delta is formed without cancellation. The
  // functions used are analytic in the discriminant, so critical damping is not a special case.
  const Scalar delta = sqrt(discriminant);
  if (alpha + delta == 0) return {start.value + start.slope * tau, start.slope};
  const Scalar slow = lambda / (alpha + delta), decay = exp(-slow * tau);
  const Scalar fast = exp(-2 * delta * tau);
  const Scalar s = delta > 0 ? -expm1(-2 * delta * tau) / (2 * delta) : tau;
  // decay * (c - alpha s) with c - alpha s = fast + (slow) * (...) kept free of cancellation:
  // c - alpha s = (1 + fast) / 2 - alpha s = fast - slow s,  c + alpha s = 1 + slow s.
  return {decay * (start.value * (1 + slow * s) + start.slope * s),
          decay * (start.slope * (fast - slow * s) - lambda * start.value * s)};
}

// Response from rest after tau of y'' + kappa y' + lambda y = Re(force exp(i omega tau)), for an
// under-damped mode at or near resonance: difference quotients instead of a steady response that
// grows without bound there.
template <class Scalar>
OscillatorState<Scalar> forced_from_rest(Scalar kappa, Scalar lambda, std::complex<Scalar> force,
                                         Scalar omega, Scalar tau) {
  using Complex = std::complex<Scalar>;
  const Scalar alpha = kappa / 2, damped = std::sqrt(lambda - alpha * alpha);
  const Complex drive(0, omega);
  // (exp(drive tau) - exp(root tau)) / (drive - root), exact as drive -> root.
  const auto quotient = [&](Complex root) {
    const Complex half = (drive - root) * (tau / 2);
    // sinh(z)/z by its real and imaginary parts; both roots sit near the imaginary axis.
    const Complex ratio = std::abs(half) < Scalar(1e-4) ? Scalar(1) + half * half / Scalar(6)
                                                        : std::sinh(half) / half;
    return std::exp((drive + root) * (tau / 2)) * ratio * tau;
  };
  const Complex upper(-alpha, damped), lower(-alpha, -damped);
  const Complex split = upper - lower;
  const Complex at_upper = quotient(upper), at_lower = quotient(lower);
  return {std::real(force * (at_upper - at_lower) / split),
          std::real(force * (upper * at_upper - lower * at_lower) / split)};
}

}  // namespace vibro_impact
