#include "motion.hpp"

#include <algorithm>
#include <cmath>

#include "tolerances.hpp"

namespace vibro_impact::detail {

void clear(const Chain &chain, Motion &motion) {
  for (List<Real> *list : {&motion.x, &motion.v}) list->assign(chain.padded, 0.0);
  for (List<double> *list : {&motion.acceleration, &motion.x_terms, &motion.v_terms})
    list->assign(chain.padded, 0.0);
  motion.acceleration_known = false;
}

void set_turn(const Chain &chain, Motion &motion) {
  motion.turned = 0;
  sincos(motion.now.phase * chain.omega, motion.turn.sine, motion.turn.cosine);
}

// With w = Omega tau, e^(iw) = 1 + iw + (cos w - 1) + i (sin w - w). The last two are of second
// order and are found in double precision. From time to time the turn is computed anew.
void pass_time(const Chain &chain, const Real &tau, Motion &motion) {
  pass(tau, chain.clock, motion.now);
  motion.acceleration_known = false;
  if (chain.omega == 0.0) return;
  if (++motion.turned > most_turns) return set_turn(chain, motion);
  const Real angle = chain.omega * tau;
  const Pair higher = higher_orders_of_turn(angle.hi);
  Real &c = motion.turn.cosine, &s = motion.turn.sine;
  const RealPair z{Pair{c.hi, s.hi}, Pair{c.lo, s.lo}}, iz{Pair{-s.hi, c.hi}, Pair{-s.lo, c.lo}};
  const RealPair after = z + (both(angle) * iz + (higher[0] * z.hi + higher[1] * iz.hi));
  c = {after.hi[0], after.lo[0]};
  s = {after.hi[1], after.lo[1]};
}

void find_acceleration(const Chain &chain, Motion &motion) {
  if (motion.acceleration_known) return;
  motion.acceleration_known = true;
  const ContactMode &mode = *motion.mode;
  const RealPair cosine = both(motion.turn.cosine), sine = both(motion.turn.sine);
  const Pair beta{chain.beta, chain.beta};
  const auto z_of = [&](std::size_t i) { return load(&motion.x[i]) + load(&motion.v[i]) * beta; };
  // The tension k (z_i - z_(i-1)) of the spring and the damper of a link, z = x + beta v. The
  // difference comes first: a neighbour at the same place exerts no force at all.
  const auto tension_of = [&](std::size_t i, const RealPair &before, const RealPair &z) {
    return (z - middle(before, z)) * pair(&chain.link[i]);
  };
  RealPair z = z_of(0), tension = tension_of(0, {}, z);
  for (std::size_t i = 0; i < chain.padded; i += 2) {
    RealPair after, next;
    if (i + 2 < chain.padded) {
      after = z_of(i + 2);
      next = tension_of(i + 2, z, after);
    }
    RealPair force = middle(tension, next) - tension;
    if (chain.a[i] != 0.0 || chain.a[i + 1] != 0.0) force += cosine * pair(&chain.a[i]);
    if (chain.b[i] != 0.0 || chain.b[i + 1] != 0.0) force += sine * pair(&chain.b[i]);
    if (chain.p[i] != 0.0 || chain.p[i + 1] != 0.0) force += pair(&chain.p[i]);
    if (chain.grounded) force -= z * pair(&chain.ground[i]);
    put(force.hi / pair(&mode.mass[i]), &motion.acceleration[i]);
    z = after;
    tension = next;
  }
}

double time_window(const Chain &chain, double time) {
  return std::min(1.0 / chain.rate_bound, time);
}

double largest_terms(const Chain &chain, const Motion &motion, double time) {
  const double window = time_window(chain, time);
  return std::max(*std::max_element(motion.x_terms.begin(), motion.x_terms.end()),
                  chain.force_bound * window * window);
}

void place(std::size_t mass, const Real &x, const Real &v, Motion &motion) {
  motion.x[mass] = x;
  motion.v[mass] = v;
  motion.x_terms[mass] = 0.0;
  motion.v_terms[mass] = std::abs(v.hi);
  motion.acceleration_known = false;
}

bool Value::is_zero() const {
  return abs(value) <= zero_threshold * terms;
}

Real force_at_rest(const Chain &chain, std::size_t i, const Motion &motion) {
  const auto &[cosine, sine] = motion.turn;
  Real force = chain.p[i] + chain.a[i] * cosine;
  if (chain.b[i] != 0.0) force += chain.b[i] * sine;
  if (chain.ground[i] != 0.0) force -= chain.ground[i] * motion.x[i];
  if (i == 0) force -= chain.link[i] * motion.x[i];
  chain.each_link(i, [&](double stiffness, std::size_t other) {
    force += stiffness * ((motion.x[other] - motion.x[i]) + chain.beta * motion.v[other]);
  });
  return force;
}

Value force_of(const Chain &chain, const Contact &contact, const Motion &motion) {
  const std::size_t i = contact.mass;
  const double sigma = contact.sigma;
  const auto &[cosine, sine] = motion.turn;
  double slope = chain.omega * (chain.b[i] * cosine.hi - chain.a[i] * sine.hi);
  Value value;
  value.terms = sum_of_forces(chain, i, motion) + chain.stiffness_at(i) * motion.x_terms[i];
  chain.each_link(i, [&](double stiffness, std::size_t other) {
    slope += stiffness * (motion.v[other].hi + chain.beta * motion.acceleration[other]);
    value.terms += stiffness * (motion.x_terms[other] + chain.beta * motion.v_terms[other]);
  });
  value.value = scaled(force_at_rest(chain, i, motion), sigma);
  value.slope = sigma * slope;
  return value;
}

double sum_of_forces(const Chain &chain, std::size_t i, const Motion &motion) {
  double sum = std::abs(chain.p[i]) + std::abs(chain.a[i]) + std::abs(chain.b[i]) +
               chain.ground[i] * std::abs(motion.x[i].hi);
  if (i == 0) sum += chain.link[i] * std::abs(motion.x[i].hi);
  chain.each_link(i, [&](double stiffness, std::size_t other) {
    sum += stiffness * (std::abs(rounded(motion.x[other] - motion.x[i])) +
                        chain.beta * std::abs(motion.v[other].hi));
  });
  return sum;
}

}  // namespace vibro_impact::detail
