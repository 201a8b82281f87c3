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
  double length = 0.0, unit = 0.0, omega = 0.0;
  Real value = 0.0, slope = 0.0;
  double remainder = 0.0;
  std::array<Real, bound_order + 1> derivative{};

  // A part that turns within the length is taken out of the value; the others stay. The energy of
  // each derivative grows by the forcing alone.
  void add(const Part &part) {
    if (part.rate * length > 1.0) {
      value -= part.value + part.amplitude;
      return;
    }
    slope += part.slope;
    const double turn = omega * unit, square = unit * unit;
    const Real d = part.damping * unit, stiff = part.stiffness * unit * unit;
    ModalForce f{square * part.force.a, square * part.force.b, square * part.force.c};
    const double growth =
        std::hypot(f.a.hi, f.b.hi) * (length / unit) * std::pow(turn, bound_order);
    Real before = part.value, latest = part.slope * unit;
    for (int n = 2; n <= bound_order + 1; ++n) {
      const Real next = f.a + f.c - d * latest - stiff * before;
      f = {turn * f.b, -(turn * f.a), 0.0};
      before = std::exchange(latest, next);
      if (n <= bound_order) derivative[static_cast<std::size_t>(n)] += latest;
    }
    remainder += std::hypot(latest.hi, std::sqrt(stiff.hi) * before.hi) + growth;
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

// Calls `use` with each part of the share z = weight (y + d y') of a coordinate. It is one part
// within a radian. Over a longer time there are the steady response, and one free oscillation or
// two decays about the static displacement. Next to resonance these are large and cancel: it is
// one part where its energy bounds it better, as (y'^2 + lambda y^2)^(1/2) grows by the forcing at
// most.
template <class Use>
void LongFlight::each_part_of(std::size_t j, const Watch &w, double length, const Use &use) const {
  const Coordinate &c = coordinates_[j];
  const Oscillator<Real> &o = form_->oscillators[j];
  const Real &weight = w.row[j];
  const double size = std::abs(weight.hi), d = w.damping, root = std::sqrt(o.lambda.hi),
               omega = form_->omega;
  Real y = c.deviation, dy = c.dy;  // of the free part
  const ModalForce &f = c.force;
  const double modulus = std::hypot(f.a.hi, f.b.hi);
  if (o.rate * length <= 1.0 && (modulus == 0.0 || omega * length <= 1.0))
    return use(
        Part{weight * (c.y + d * dy),
             weight * (dy + d * (f.a + f.c - o.kappa * dy - o.lambda * c.y)),
             o.kappa,
             o.lambda,
             o.rate,
             infinity,  // it does not turn within the length
             {weight * (f.a + d * omega * f.b), weight * (f.b - d * omega * f.a), weight * f.c}});
  if (modulus > 0.0) {
    // The steady response to a cos + b sin is Re(s) and its derivative Re(i Omega s), with
    // s = (a - i b) / (lambda - Omega^2 + i kappa Omega).
    const Real square = Real(omega) * omega;
    const ComplexOf<Real> s =
        ComplexOf<Real>{f.a, -f.b} / ComplexOf<Real>{o.lambda - square, o.kappa * omega};
    const double whole = std::hypot(y.hi, dy.hi / root) + modulus * length / root;
    const bool turns = std::min(root, omega) * length > 1.0 && !o.has_two_decays();
    // False at resonance, where s is no number.
    const bool steady_is_smaller = std::hypot(s.re.hi, s.im.hi) <= whole;
    if (turns && !steady_is_smaller)
      return use(Part{weight * (y + d * dy), 0.0, o.kappa, o.lambda, o.rate,
                      size * whole * (1.0 + d * root)});
    const Real steady = s.re, slope = -(omega * s.im);
    y -= steady;
    dy -= slope;
    use(Part{weight * (steady + d * slope), weight * (slope - d * (square * steady)), 0.0, square,
             omega, size * std::hypot(s.re.hi, s.im.hi) * (1.0 + d * omega)});
  }
  if (!o.has_two_decays()) {
    // A coordinate without a spring has no static displacement, and its constant force drives it.
    const bool is_tied = o.lambda.hi > 0.0;
    const Real drive = is_tied ? Real(0.0) : f.c, second = drive - o.kappa * dy - o.lambda * y;
    const double amplitude = is_tied ? std::hypot(y.hi, dy.hi / root) : infinity;
    use(Part{weight * (y + d * dy),
             weight * (dy + d * second),
             o.kappa,
             o.lambda,
             o.rate,
             size * amplitude * (1.0 + d * o.rate),
             {0.0, 0.0, weight * drive}});
    return;
  }
  const Real quick = (dy - o.slow * y) / (o.fast - o.slow), slow = y - quick;
  for (const auto &[part, decay] : {std::pair{quick, o.fast}, std::pair{slow, o.slow}}) {
    const Real z = weight * part * (1.0 + d * decay);
    use(Part{z, z * decay, -decay, 0.0, -decay.hi, std::abs(z.hi)});
  }
}

// Calls `use` with each part of a contact.
template <class Use>
void LongFlight::each_part(const Watch &w, double length, const Use &use) const {
  for (std::size_t j = 0; j < coordinates_.size(); ++j)
    if (w.row[j].hi != 0.0) each_part_of(j, w, length, use);
  const double cosine = turn_.cosine.hi, sine = turn_.sine.hi, omega = form_->omega;
  if (w.a != 0.0 || w.b != 0.0)
    use(Part{w.a * cosine + w.b * sine, omega * (w.b * cosine - w.a * sine), 0.0, omega * omega,
             omega, std::hypot(w.a, w.b)});
}

Polynomial LongFlight::bound_of(std::size_t k, double l) {
  Bound bound{.length = l, .unit = leading_power(l), .omega = form_->omega};
  // Before its event a contact lies below zero by rounding only.
  if (values_[k].value.hi > 0.0) bound.value = values_[k].value;
  each_part(form_->watches[k], l, [&bound](const Part &part) { bound.add(part); });
  return bound.polynomial();
}

// The coordinates of a hidden contact cancel each other below the threshold. A part that lies below
// it alone will not show the contact. A gap that began as a power of time may be seen, and close
// again, within a time longer than the flight so far. The time is infinite if none may appear.
double LongFlight::longest_blind_step() const {
  bool may_appear = false;
  double rate = 0.0;
  for (std::size_t k = 0; k < sight_.size(); ++k) {
    if (sight_[k] != Sight::hidden) continue;
    const double threshold = zero_threshold * values_[k].terms;
    each_part(form_->watches[k], infinity, [&](const Part &part) {
      if (part.amplitude <= threshold) return;
      may_appear = true;
      rate = std::max(rate, part.rate);
    });
  }
  if (!may_appear) return infinity;
  const double radian = form_->fastest > 0.0 ? 1.0 / form_->fastest : 0.0;
  return std::min(1.0 / rate, std::max(searched_to_, radian));
}

}  // namespace vibro_impact::detail
