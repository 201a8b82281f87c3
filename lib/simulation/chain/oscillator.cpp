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
