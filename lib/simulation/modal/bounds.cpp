// Lower bounds of contacts in modal coordinates, over a time of a long flight.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "long_flight.hpp"
#include "simulation/chain/tolerances.hpp"

namespace vibro_impact::detail {

// A contact is bounded from below by its value, its slope, its derivatives of order 2 to n and
// a bound of the next one. Parts of the motion that turn within the time are taken out of these,
// and lower the value by their amplitude instead. Derivatives of order k are in units of unit^-k:
//
//   g(s) >= value + slope s + sum_(k=2)^n g_k (s/unit)^k / k!
//           - remainder (s/unit)^(n+1) / (n+1)!,   n = bound_order
//
// Parts cancel each other: the slow ones of identical oscillators at a mass that hardly moves, and
// the terms of the slope of a fast mode that has come to rest. The parts and their sums have twice
// the precision, and the slope is the sum over the parts that stay.
struct LongFlight::Bound {
  double length = 0.0, unit = 0.0;
  Real value = 0.0, slope = 0.0;
  double remainder = 0.0;
  std::array<Real, bound_order + 1> derivative{};

  // A part that turns within the length is taken out of the value; the others stay.
  void add(const Part &part) {
    if (part.rate * length > 1.0) {
      value -= part.value + part.amplitude;
      return;
    }
    slope += part.slope;
    const Real d = part.damping * unit, stiff = part.stiffness * unit * unit;
    Real before = part.value, latest = part.slope * unit;
    for (int n = 2; n <= bound_order + 1; ++n) {
      Real next = -(d * latest) - stiff * before;
      if (n == 2) next += part.drive * unit * unit;
      before = std::exchange(latest, next);
      if (n <= bound_order) derivative[static_cast<std::size_t>(n)] += latest;
    }
    remainder += std::hypot(latest.hi, std::sqrt(stiff.hi) * before.hi);
  }
  // In u = s / length, from 0 to 1.
  Polynomial polynomial() const {
    Polynomial p;
    p.order = bound_order + 1;
    p.coefficient[0] = value.hi;
    p.coefficient[1] = slope.hi * length;
    double power = length / unit;
    for (int n = 2; n <= bound_order + 1; ++n) {
      power *= length / unit / n;
      const auto i = static_cast<std::size_t>(n);
      p.coefficient[i] = power * (n <= bound_order ? derivative[i].hi : -remainder);
    }
    return p;
  }
};

// The derivatives of all coordinates at `searched_to_`, in this unit. Those of a stiff coordinate
// cancel, as do those of different coordinates at a mass that hardly moves: twice the precision
// keeps them.
void LongFlight::find_derivatives(double unit) {
  if (unit == unit_) return;
  unit_ = unit;
  const double turn = omega_ * unit, square = unit * unit;
  for (std::size_t j = 0; j < coordinates_.size(); ++j) {
    Coordinate &c = coordinates_[j];
    const Oscillator<Real> &o = form_->exact[j];
    const Real kappa = o.kappa * unit, lambda = o.lambda * unit * unit;
    ModalForce<Real> f{square * c.force.a, square * c.force.b, square * c.force.c};
    c.derivative[1] = c.dy * unit;
    c.derivative[0] = c.y;
    for (std::size_t n = 2; n < c.derivative.size(); ++n) {
      c.derivative[n] = f.a + f.c - kappa * c.derivative[n - 1] - lambda * c.derivative[n - 2];
      f = {turn * f.b, -(turn * f.a), 0.0};
    }
  }
}

// A bound of the derivative of order n over the length of a bound: the energy of each derivative
// grows by the forcing alone.
double LongFlight::derivative_bound(const Coordinate &c, const Oscillator<double> &o, int n,
                                    double length) const {
  const auto i = static_cast<std::size_t>(n);
  return std::hypot(c.derivative[i].hi, std::sqrt(o.lambda) * unit_ * c.derivative[i - 1].hi) +
         c.modulus * unit_ * length * std::pow(omega_ * unit_, n - 1);
}

// Calls `use` with each part: the steady response, and one free oscillation or two decays about the
// static displacement. Next to resonance these are large and cancel. The coordinate is one part
// where its energy bounds it better: (y'^2 + lambda y^2)^(1/2) grows by the forcing at most.
template <class Use>
void LongFlight::each_part(const Watch &w, const Coordinate &c, const Oscillator<Real> &o,
                           const Real &weight, double length, const Use &use) const {
  const double size = std::abs(weight.hi), d = w.damping;
  Real y = c.deviation, dy = c.dy;  // of the free part
  if (c.modulus > 0.0) {
    // The steady response to a cos + b sin is Re(s) and its derivative Re(i Omega s), with
    // s = (a - i b) / (lambda - Omega^2 + i kappa Omega).
    const Real square = Real(omega_) * omega_;
    const ComplexOf<Real> s = ComplexOf<Real>{c.force.a, -c.force.b} /
                              ComplexOf<Real>{o.lambda - square, o.kappa * omega_};
    const double root = std::sqrt(o.lambda.hi),
                 whole = std::hypot(y.hi, dy.hi / root) + c.modulus * length / root;
    const bool turns = std::min(root, omega_) * length > 1.0 && !o.has_two_decays();
    // False at resonance, where s is no number.
    const bool steady_is_smaller = std::hypot(s.re.hi, s.im.hi) <= whole;
    if (turns && !steady_is_smaller)
      return use(Part{weight * (y + d * dy), 0.0, o.kappa, o.lambda, o.rate,
                      size * whole * (1.0 + d * root)});
    const Real steady = s.re, slope = -(omega_ * s.im);
    y -= steady;
    dy -= slope;
    use(Part{weight * (steady + d * slope), weight * (slope - d * (square * steady)), 0.0, square,
             omega_, size * std::hypot(s.re.hi, s.im.hi) * (1.0 + d * omega_)});
  }
  if (!o.has_two_decays()) {
    // A coordinate without a spring has no static displacement, and its constant force drives it.
    const bool is_tied = o.lambda.hi > 0.0;
    const Real drive = is_tied ? Real(0.0) : c.force.c,
               second = drive - o.kappa * dy - o.lambda * y;
    const double amplitude = is_tied ? std::hypot(y.hi, dy.hi / std::sqrt(o.lambda.hi)) : infinity;
    use(Part{weight * (y + d * dy), weight * (dy + d * second), o.kappa, o.lambda, o.rate,
             size * amplitude * (1.0 + d * o.rate), weight * drive});
    return;
  }
  const Real quick = (dy - o.slow * y) / (o.fast - o.slow), slow = y - quick;
  for (const auto &[part, decay] : {std::pair{quick, o.fast}, std::pair{slow, o.slow}}) {
    const Real z = weight * part * (1.0 + d * decay);
    use(Part{z, z * decay, -decay, 0.0, -decay.hi, std::abs(z.hi)});
  }
}

Polynomial LongFlight::bound_of(std::size_t k, double l) {
  const Watch &w = form_->watches[k];
  Bound bound{.length = l, .unit = leading_power(l)};
  find_derivatives(bound.unit);
  // Before its event a contact lies below zero by rounding only.
  if (values_[k].value.hi > 0.0) bound.value = values_[k].value;
  const double damping = w.damping / bound.unit;
  for (std::size_t j = 0; j < coordinates_.size(); ++j) {
    const Coordinate &c = coordinates_[j];
    const Oscillator<double> &o = form_->rounded[j];
    const Real &weight = w.row[j];
    if (weight.hi == 0.0) continue;
    if (!(o.rate * l <= 1.0 && (c.modulus == 0.0 || omega_ * l <= 1.0))) {
      each_part(w, c, form_->exact[j], weight, l, [&bound](const Part &part) { bound.add(part); });
      continue;
    }
    bound.slope += weight * (c.dy + damping * c.derivative[2] / bound.unit);
    for (std::size_t n = 2; n <= bound_order; ++n) {
      bound.derivative[n] += weight * c.derivative[n];
      if (damping > 0.0) bound.derivative[n] += weight * (damping * c.derivative[n + 1]);
    }
    bound.remainder += std::abs(weight.hi) * (derivative_bound(c, o, bound_order + 1, l) +
                                              damping * derivative_bound(c, o, bound_order + 2, l));
  }
  if (w.a == 0.0 && w.b == 0.0) return bound.polynomial();
  const ModalForce<double> &f = watch_forces_[k];
  bound.add({f.a, omega_ * f.b, 0.0, omega_ * omega_, omega_, std::hypot(f.a, f.b)});
  return bound.polynomial();
}

// The coordinates of a hidden contact cancel each other below the threshold. A part that lies below
// it alone will not show the contact. A gap that began as a power of time may be seen, and close
// again, within a time longer than the flight so far.
double LongFlight::longest_blind_step() const {
  double rate = 0.0;
  for (std::size_t k = 0; k < hidden_.size(); ++k) {
    if (!hidden_[k]) continue;
    const Watch &w = form_->watches[k];
    if (w.a != 0.0 || w.b != 0.0) rate = std::max(rate, omega_);
    const double threshold = zero_threshold * values_[k].terms;
    for (std::size_t j = 0; j < coordinates_.size(); ++j)
      each_part(w, coordinates_[j], form_->exact[j], w.row[j], infinity, [&](const Part &part) {
        if (!(part.amplitude <= threshold)) rate = std::max(rate, part.rate);
      });
  }
  if (rate == 0.0) return longest_step;
  return std::min(1.0 / rate, std::max(searched_to_, 1.0 / fastest_));
}

}  // namespace vibro_impact::detail
