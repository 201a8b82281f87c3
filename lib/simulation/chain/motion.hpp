// The motion of a run at one instant, in the modal coordinates of its contact mode.
#pragma once

#include <complex>
#include <vector>

#include "contact_mode.hpp"
#include "pair.hpp"
#include "stop_state.hpp"
#include "vibro_impact/instant.hpp"

namespace vibro_impact::detail {

struct Motion {
  // The time of the motion is now + now_low, where |now_low| lies below the rounding of the phase.
  // The sum of many steps then has no rounding, even of steps that the phase cannot resolve.
  Instant now;
  double now_low = 0.0;
  std::complex<double> turn;  // e^(i Omega t)
  const ContactMode *mode = nullptr;
  // The coordinates are the unevaluated sums y + y_low and y' + y'_low, each of twice the
  // precision. A gap far below the rounding of y then keeps its digits.
  PerCoordinate y, dy, y_low, dy_low;
  // True of a coordinate whose deviation from its steady response has died out: y and y' are set to
  // the steady response. One for each coordinate.
  std::vector<char> following;
  bool any_following = false;
};

// Sets the clock to an instant, with the forcing.
void set_clock(Motion &motion, const Clock &clock, const Instant &instant);

// Moves the clock on by tau, with the forcing.
void pass_time(Motion &motion, const Clock &clock, double tau);

// Time from the motion to an instant.
double time_until(const Motion &motion, const Instant &instant, const Clock &clock);

// Sets y' of decays by (2), which makes it depend on y.
void tie_decays(Motion &motion);

// Completes an impact or a mode change: sets y' of decays, and ends the following of all
// coordinates.
void complete_change(Motion &motion);

// The largest rate of a coordinate that moves on its own, and of the forcing. It is 0 where nothing
// moves, and in a free fall.
double rate_in_motion(const Motion &motion);

// The unit of time of the impacts at a stop: that of the fastest rate, or the duration of these
// impacts if it is shorter. A flight may be short against every rate.
double unit_of_time(const ContactMode &mode, const StopState &stop);

// Displacement and velocity of a mass, counted from 0. The displacement is clamped to the stops.
double displacement(const Motion &motion, std::size_t mass);
double velocity(const Motion &motion, std::size_t mass);

// (3) of a contact, its gap or hold force, rounded relative to its largest term.
inline double evaluate(const Contact &contact, const Motion &motion) {
  double sum = contact.offset + dot(contact.row, motion.y);
  if (contact.held)
    sum +=
        contact.damping * dot(contact.row, motion.dy) +
        (contact.forcing.real() * motion.turn.real() - contact.forcing.imag() * motion.turn.imag());
  return sum;
}

// A gap g and its speed g'.
struct Gap {
  double value = 0.0, speed = 0.0;
};

// The gap of a free mass, from coordinates of twice the precision.
inline Gap gap_at(const Contact &contact, const Motion &motion) {
  return {dot_twofold(contact.offset, contact.row, motion.y, motion.y_low) + contact.offset_low,
          dot_twofold(0.0, contact.row, motion.dy, motion.dy_low)};
}

// The same, or exact values where they are known: those of a mass at rest at the stop, or at an
// impact.
inline Gap gap_of(const Contact &contact, const StopState &stop, const Motion &motion) {
  if (stop.contact.at_rest) return {};
  if (stop.contact.speed) return {0.0, *stop.contact.speed};
  return gap_at(contact, motion);
}

// The sum of the moduli of the terms of (3), which is the scale of its rounding.
double terms_of(const Contact &contact, const Motion &motion);

// True when (3) exceeds `resolved_ratio` times the sum of the moduli of its terms. Smaller gaps
// lose more bits to cancellation in coordinates of one precision.
bool is_resolved(const Contact &contact, const Motion &motion);

// Sets the displacements and velocities of all masses.
void set_state(const Motion &motion, const std::vector<StopState> &stops, const Scene &scene,
               MotionState &state);

// The acceleration y'' of two coordinates.
inline Pair acceleration(const Motion &motion, Eigen::Index j) {
  const ModalCoordinates &all = motion.mode->coordinates;
  return pair(all.force_re.data() + j) * motion.turn.real() -
         pair(all.force_im.data() + j) * motion.turn.imag() + pair(all.constant.data() + j) -
         pair(all.kappa.data() + j) * pair(motion.dy.data() + j) -
         pair(all.lambda.data() + j) * pair(motion.y.data() + j);
}

// The force, towards the stop of a contact, that acts on its mass if the mass is at rest there. The
// mass moves with this gap speed: F = -m g'' - drag g'. No stiffness multiplies a rounded position.
double pressing_force(const Scene &scene, const Contact &contact, const Motion &motion,
                      double gap_speed);

}  // namespace vibro_impact::detail
