// The motion of a run at one instant: displacements and velocities of the masses, in twice the
// precision.
#pragma once

#include "contact_mode.hpp"
#include "twofold_instant.hpp"

namespace vibro_impact::detail {

// e^(i Omega t), in twice the precision.
struct Turn {
  Real cosine = 1.0, sine = 0.0;
};

// Numbers of each mass, padded like those of the chain.
struct Motion {
  TwofoldInstant now;
  Turn turn;
  int turned = 0;  // steps since `turn` was computed from the phase
  const ContactMode *mode = nullptr;
  List<Real> x, v;
  // The rounded sum of terms of twice the precision, if it is known.
  List<double> acceleration;
  bool acceleration_known = false;
  // Sums of the moduli of the terms that x and v are made of, over the latest flight: a mass that
  // passes x = 0 onto a stop at 0 has no terms at that instant. While a mass stays where it was
  // placed, its x is exact and has no terms.
  List<double> x_terms, v_terms;
};

// The time over which the rounding of the motion is judged: a radian of the fastest rate, or the
// time so far where that is shorter, as on soft springs.
double time_window(const Chain &chain, double time);

// The largest terms of a displacement, or the way that the external forces move a mass within the
// window of this time: beside these a displacement may be zero.
double largest_terms(const Chain &chain, const Motion &motion, double time);

// Sets all masses to rest at zero. The time, the turn and the contact mode stay.
void clear(const Chain &chain, Motion &motion);

// Computes the turn of a motion from its phase.
void set_turn(const Chain &chain, Motion &motion);

// Moves the clock on by a step, with e^(i Omega t).
void pass_time(const Chain &chain, const Real &tau, Motion &motion);

// Sets the acceleration x'' = M^-1 (F - C x' - K x) of the free masses, unless it is known.
void find_acceleration(const Chain &chain, Motion &motion);

// The force on a mass at rest: external forces, springs and dampers.
Real force_at_rest(const Chain &chain, std::size_t mass, const Motion &motion);

// Puts a mass, at an instant, to a displacement and a velocity that are known exactly.
void place(std::size_t mass, const Real &x, const Real &v, Motion &motion);

// The gap or the pressing force of a contact and its slope. The slope of a force is rounded.
struct Value {
  Real value, slope;
  double terms = 0.0;  // the sum of the moduli of the terms of the value
  bool is_zero() const;
};

inline Value gap_of(const Contact &contact, const Motion &motion) {
  const std::size_t i = contact.mass;
  return {scaled(contact.position - motion.x[i], contact.sigma),
          scaled(motion.v[i], -contact.sigma), std::abs(contact.position) + motion.x_terms[i]};
}

// The slope of a force is that of the acceleration of the motion, known or not.
Value force_of(const Chain &chain, const Contact &contact, const Motion &motion);

inline Value evaluate(const Chain &chain, const Contact &contact, const Motion &motion) {
  return contact.held ? force_of(chain, contact, motion) : gap_of(contact, motion);
}

// The sum of the moduli of the forces on a mass at rest (from 0): springs by their stretch, dampers
// and external forces. In double precision, a hold force is rounded relative to it.
double sum_of_forces(const Chain &chain, std::size_t mass, const Motion &motion);

}  // namespace vibro_impact::detail
