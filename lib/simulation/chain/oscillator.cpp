#include "oscillator.hpp"

#include <cmath>

namespace vibro_impact::detail {

using Complex = std::complex<double>;

OscillatorState free_response(double kappa, double lambda, OscillatorState start, double tau) {
  const double alpha = kappa / 2, discriminant = alpha * alpha - lambda;
  if (discriminant < 0) {
    const double omega = std::sqrt(-discriminant), decay = std::exp(-alpha * tau);
    const double c = std::cos(omega * tau), s = std::sin(omega * tau) / omega;
    return {decay * (start.value * (c + alpha * s) + start.slope * s),
            decay * (start.slope * (c - alpha * s) - lambda * start.value * s)};
  }
  // The roots are -slow and -(slow + 2 delta), and slow = alpha - delta is formed without
  // cancellation. The functions are analytic in the discriminant: critical damping is no special
  // case.
  const double delta = std::sqrt(discriminant);
  if (alpha + delta == 0) return {start.value + start.slope * tau, start.slope};
  const double slow = lambda / (alpha + delta), decay = std::exp(-slow * tau);
  const double fast = std::exp(-2 * delta * tau);
  const double s = delta > 0 ? -std::expm1(-2 * delta * tau) / (2 * delta) : tau;
  // c = (1 + fast) / 2, so that c - alpha s = fast - slow s and c + alpha s = 1 + slow s.
  return {decay * (start.value * (1 + slow * s) + start.slope * s),
          decay * (start.slope * (fast - slow * s) - lambda * start.value * s)};
}

OscillatorState forced_from_rest(double kappa, double lambda, Complex force, Complex force_after,
                                 double omega, double tau) {
  const Complex drive(0, omega);
  const double alpha = kappa / 2, damped = std::sqrt(lambda - alpha * alpha);
  // (F exp(drive tau) - F exp(root tau)) / (drive - root), without cancellation as drive -> root.
  const auto quotient = [&](Complex root) {
    const Complex half = (drive - root) * (tau / 2);
    if (std::abs(half) > 1.0) return (force_after - force * std::exp(root * tau)) / (drive - root);
    const Complex ratio = std::abs(half) < 1e-4 ? 1.0 + half * half / 6.0 : std::sinh(half) / half;
    return force_after * std::exp(-half) * ratio * tau;
  };
  const Complex upper(-alpha, damped), lower(-alpha, -damped);
  const Complex split = upper - lower, of_upper = quotient(upper), of_lower = quotient(lower);
  return {std::real((of_upper - of_lower) / split),
          std::real((upper * of_upper - lower * of_lower) / split)};
}

OscillatorState forced_drift(Complex force, Complex force_after, double omega, double tau) {
  const Complex drive(0, omega), z = drive * tau;
  if (std::abs(z) > 1.0)
    return {std::real((force_after - force * (1.0 + z)) / (drive * drive)),
            std::real((force_after - force) / drive)};
  Complex second = 0.0;  // (exp(z) - 1 - z) / z^2, from its series
  for (int n = 20; n >= 2; --n) second = (1.0 + second * z) / static_cast<double>(n);
  return {tau * tau * std::real(force * second), tau * std::real(force * (1.0 + z * second))};
}

OscillatorState change_by_series(double kappa, double lambda, OscillatorState start, Complex force,
                                 double constant, double omega, double tau) {
  kappa *= tau;
  lambda *= tau * tau;
  force *= tau * tau;
  constant *= tau * tau;
  double before = start.value, term = start.slope * tau;
  OscillatorState change{term, 0.0};
  for (int n = 0; n < 26; ++n) {
    const double next = (force.real() + constant - lambda * before - kappa * (n + 1) * term) /
                        ((n + 1.0) * (n + 2.0));
    before = term;
    term = next;
    change.value += term;
    change.slope += (n + 2) * term;
    force *= Complex(0.0, omega * tau / (n + 1));
    constant = 0.0;
  }
  return {change.value, tau > 0.0 ? change.slope / tau : 0.0};
}

}  // namespace vibro_impact::detail
