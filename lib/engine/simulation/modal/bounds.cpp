// Bounds of a contact ahead of a long flight.
#include <algorithm>
#include <cmath>
#include <utility>

#include "long_flight.hpp"
#include "simulation/chain/tolerances.hpp"

namespace vibro_impact::detail {

namespace {

// The first positive root of p + q s + c s^2, where p >= 0, or infinity.
double first_root_of(double p, double q, double c) {
  const double discriminant = q * q - 4.0 * c * p;
  if (discriminant < 0.0) return infinity;
  const double root = std::sqrt(discriminant);
  if (q > 0.0) return c < 0.0 ? (q + root) / (-2.0 * c) : infinity;
  if (p == 0.0) return q < 0.0 || c < 0.0 ? 0.0 : infinity;
  return root > q ? 2.0 * p / (root - q) : infinity;
}

// The steady response a cos + b sin and its derivative, at the phase of the force.
struct SteadyResponse {
  double y, dy, modulus;
};
SteadyResponse steady_response(const Oscillator<double> &o, const ModalForce<double> &f,
                               double omega) {
  // y = Re((a - i b) / D) with D = lambda - Omega^2 + i kappa Omega.
  const double re = o.lambda - omega * omega, im = o.kappa * omega, n = re * re + im * im;
  const double y = (f.a * re - f.b * im) / n, z = (f.b * re + f.a * im) / n;
  return {y, omega * z, std::hypot(y, z)};
}

}  // namespace

// Parabolas below the cubic, one after the other, move on like Newton's steps.
double ContactBound::first_root(double l) const {
  double s = 0.0, p = value - away, q = rate;
  if (p < 0.0) return 0.0;
  if (p > l * (std::abs(q) + l * (0.5 * std::abs(second) + l * bound))) return l;
  const double c = 0.5 * std::min(second, second - bound * l);
  for (int k = 0; k < 4; ++k) {
    s += first_root_of(p, q, c);
    if (!(s < l)) return l;
    p = value - away + s * (rate + s * (0.5 * second - s * bound / 6.0));
    q = rate + s * (second - 0.5 * s * bound);
    if (p <= 0.0) break;
  }
  return s;
}

// A coordinate that turns within l is bounded in parts, each by its derivatives or by its
// amplitude: the steady response, and one free oscillation or two decays about the static
// displacement. A part that is bounded by its amplitude is taken out of the value and of the rate;
// the others stay.
void LongFlight::add_parts(const Watch &w, const Coordinate &c, const Oscillator<double> &o,
                           double weight, double l, ContactBound &bound) const {
  const double size = std::abs(weight), d = w.damping, square = omega_ * omega_;
  double y = c.deviation, dy = c.d[1], second = c.d[2], third = c.d[3];  // of the free part
  if (c.modulus > 0.0) {
    const SteadyResponse s = steady_response(o, c.force, omega_);
    const double amplitude = size * s.modulus * (1.0 + d * omega_),
                 value = weight * (s.y + d * s.dy), rate = weight * (s.dy - d * square * s.y);
    y -= s.y;
    dy -= s.dy;
    second += square * s.y;
    third += square * s.dy;
    if (omega_ * l <= 1.0) {
      bound.second -= square * value;
      bound.bound += amplitude * square * omega_;
    } else {
      bound.value -= value;
      bound.rate -= rate;
      bound.away += amplitude;
    }
  }
  const double root = std::sqrt(o.lambda);
  if (o.rate * l <= 1.0) {
    bound.second += weight * (second + d * third);
    bound.bound += size * std::hypot(third, root * second) * (1.0 + d * (o.kappa + root));
    return;
  }
  if (!o.has_two_decays()) {
    bound.value -= weight * (y + d * dy);
    bound.rate -= weight * (dy + d * second);
    bound.away += size * std::hypot(y, dy / root) * (1.0 + d * o.rate);
    return;
  }
  const double quick = (dy - o.slow * y) / (o.fast - o.slow), slow = y - quick;
  for (const auto &[part, decay] : {std::pair{quick, o.fast}, std::pair{slow, o.slow}}) {
    const double z = weight * part * (1.0 + d * decay);
    if (-decay * l <= 1.0) {
      bound.second += z * decay * decay;
      bound.bound += std::abs(z * decay * decay * decay);
    } else {
      bound.value -= z;
      bound.rate -= z * decay;
      bound.away += std::abs(z);
    }
  }
}

ContactBound LongFlight::bound_of(std::size_t k, double l) const {
  const std::size_t watch = form_->watch_of[k];
  const Watch &w = form_->watches[watch];
  const double sign = sign_of(k), square = omega_ * omega_;
  ContactBound bound;
  bound.value = std::max(0.0, values_[k].value.hi);
  bound.rate = values_[k].rate.hi;
  for (std::size_t j = 0; j < coordinates_.size(); ++j) {
    const Coordinate &c = coordinates_[j];
    const Oscillator<double> &o = form_->rounded[j];
    const double weight = sign * w.row[j];
    if (weight == 0.0) continue;
    if (o.rate * l <= 1.0 && (c.modulus == 0.0 || omega_ * l <= 1.0)) {
      bound.second += weight * (c.d[2] + w.damping * c.d[3]);
      bound.bound += std::abs(weight) * (c.third + w.damping * c.fourth +
                                         c.modulus * square * l * (1.0 + w.damping * omega_));
    } else {
      add_parts(w, c, o, weight, l, bound);
    }
  }
  if (w.a == 0.0 && w.b == 0.0) return bound;
  const ModalForce<double> &f = watch_forces_[watch];
  const double modulus = std::hypot(f.a, f.b);
  if (omega_ * l <= 1.0) {
    bound.second -= square * sign * f.a;
    bound.bound += square * omega_ * modulus;
  } else {
    bound.value -= sign * f.a;
    bound.rate -= sign * omega_ * f.b;
    bound.away += modulus;
  }
  return bound;
}

}  // namespace vibro_impact::detail
