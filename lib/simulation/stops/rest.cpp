// The derivatives of the motion follow from the equation of motion:
// x^(n+2) = M^-1 (F^(n) - C x^(n+1) - K x^(n)) (8). The force on a mass at rest depends on those of
// its neighbours, which have been decided at the orders before.
//
// Derivatives of order n are carried in the unit rate^n. The rate is the power of two above all
// rates of the chain: as a unit it rounds nothing, and no derivative overflows.
#include "rest.hpp"

#include <algorithm>
#include <cmath>

#include "simulation/chain/tolerances.hpp"

namespace vibro_impact::detail {

// The force of springs and dampers on a mass at order n, over rate^n.
RestDecision::Term RestDecision::springs_on(const Chain &chain, std::size_t i) const {
  const double damping = chain.beta * chain.rate_unit;
  Term force;
  const std::size_t ground = chain.masses;  // the last entry, which never moves
  // Differences first: a neighbour at the same place exerts no force at all.
  const auto add_spring = [&](double stiffness, std::size_t other) {
    if (stiffness == 0.0) return;
    const Term &x = order_n_[i], &v = order_n_plus_1_[i], &x_other = order_n_[other],
               &v_other = order_n_plus_1_[other];
    const Real stretch = x.value - x_other.value, rate = v.value - v_other.value;
    force.value -= stiffness * (stretch + damping * rate);
    force.terms += stiffness * (std::abs(stretch.hi) + x.terms + x_other.terms +
                                damping * (std::abs(rate.hi) + v.terms + v_other.terms));
  };
  add_spring(chain.link[i], i > 0 ? i - 1 : ground);
  add_spring(chain.above(i), i + 1);
  add_spring(chain.ground[i], ground);
  return force;
}

int RestDecision::decide(const Chain &chain, const Motion &motion,
                         std::vector<RestingMass> &masses) {
  const std::size_t n = chain.masses;
  const double rate = chain.rate_unit;
  kind_.resize(n);
  for (std::vector<Term> *order : {&order_n_, &order_n_plus_1_, &order_n_plus_2_})
    order->resize(n + 1);
  for (std::size_t i = 0; i < n; ++i) {
    kind_[i] = motion.mode->held[i] != 0 ? Kind::held : Kind::moving;
    order_n_[i] = {motion.x[i], motion.x_terms[i]};
    order_n_plus_1_[i] = {motion.v[i] * (1.0 / rate), motion.v_terms[i] / rate};
  }
  for (const RestingMass &mass : masses) kind_[mass.contact.mass] = Kind::undecided;
  Real cosine = motion.turn.cosine, sine = motion.turn.sine;
  double power = 1.0;  // (Omega / rate)^order
  const int most_orders = 2 * static_cast<int>(n) + 4;
  int order = 0;
  const auto force_at = [&](std::size_t i) {
    Term force = springs_on(chain, i);
    force.value += chain.a[i] * cosine + chain.b[i] * sine;
    force.terms += (std::abs(chain.a[i]) + std::abs(chain.b[i])) * power;
    if (order == 0) {
      force.value += chain.p[i];
      force.terms += std::abs(chain.p[i]);
    }
    return force;
  };
  std::size_t undecided = masses.size();
  for (; order < most_orders; ++order) {
    for (RestingMass &mass : masses) {
      const std::size_t i = mass.contact.mass;
      if (kind_[i] != Kind::undecided) continue;
      const Term force = force_at(i);
      const bool is_zero =
          order < mass.known_zeros || !(abs(force.value) > zero_threshold * force.terms);
      if (is_zero) continue;
      --undecided;
      const double push = mass.contact.sigma * force.value.hi;
      mass.held = push > 0.0;
      kind_[i] = mass.held ? Kind::held : Kind::moving;
      const double derivative = std::abs(push) * std::pow(rate, order);
      // The gap of a released mass has two zeros more than its acceleration.
      mass.at = mass.held ? ExactZeros{order, derivative}
                          : ExactZeros{order + 2, derivative / chain.mass[i]};
    }
    if (undecided == 0) break;
    for (std::size_t i = 0; i < n; ++i) {
      order_n_plus_2_[i] = {};
      if (kind_[i] != Kind::moving) continue;
      const Term force = force_at(i);
      const double inertia = chain.mass[i] * rate * rate;
      order_n_plus_2_[i] = {force.value / Real(inertia), force.terms / inertia};
    }
    order_n_.swap(order_n_plus_1_);
    order_n_plus_1_.swap(order_n_plus_2_);
    const Real slower = chain.omega / Real(rate), before = cosine;
    cosine = -(slower * sine);
    sine = slower * before;
    power *= slower.hi;
  }
  return std::min(order + 1, most_orders);
}

}  // namespace vibro_impact::detail
