// The motion of a run at one instant, in the modal coordinates of its contact mode.
#pragma once

#include <complex>
#include <vector>

#include "contact_mode.hpp"
#include "oscillator.hpp"
#include "pair.hpp"
#include "stop_state.hpp"
#include "vibro_impact/instant.hpp"

namespace vibro_impact::detail {

struct Motion {
  // The time of the motion is now + now_rest, where |now_rest| lies below the rounding of the
  // phase. The sum of many steps then has no rounding, even of steps that the phase cannot resolve.
  Instant now;
  double now_rest = 0.0;
  std::complex<double> turn;  // e^(i Omega t)
  const ContactMode *mode = nullptr;
  PerCoordinate y, dy;
  // True of a coordinate whose deviation from its steady response has died out: y and y' are set to
  // the steady response. One for each coordinate of a stiff contact mode, else empty.
  std::vector<char> following;
  // A slow coordinate is evaluated from its state after the latest impact or mode change. A sum
  // over steps would keep the rounding of each step, because hardly any force pulls the coordinate
  // back.
  struct Change {
    Instant instant;
    double rest = 0.0;
    std::complex<double> turn;
    std::vector<OscillatorState> states;  // one for each slow coordinate
  } change;
};

// Sets the clock to an instant, with the forcing.
void set_clock(Motion &motion, const Clock &clock, const Instant &instant);

// Moves the clock on by tau, with the forcing.
void pass_time(Motion &motion, const Clock &clock, double tau);

// Time from the motion to an instant.
double time_until(const Motion &motion, const Instant &instant, const Clock &clock);

// Sets the dependent coordinates after a move: y' of decays by (2), coordinates that follow their
// steady response, and slow coordinates.
void complete_move(Motion &motion, const Clock &clock);

// Completes an impact or a mode change: sets y' of decays by (2), ends the following of all
// coordinates, and stores the states of the slow coordinates in motion.change.
void complete_change(Motion &motion);

// Lets damped coordinates follow their steady response once the deviation d = y - steady has died
// out: in displacement and acceleration, d lies below the rounding of the whole motion or of the
// steady response. The steps of a stiff scene are then as long as the other coordinates allow.
void let_dead_coordinates_follow(Motion &motion, double omega);

// The largest rate of a coordinate that moves on its own, and of the forcing. It is 0 where nothing
// moves, and in a free fall.
double rate_in_motion(const Motion &motion);

// The unit of time of the impacts at a stop: that of the fastest rate, or the duration of these
// impacts if it is shorter. A flight may be short against every rate.
double unit_of_time(const ContactMode &mode, const StopState &stop);

// Moves to `target` in closed form. `change` is set to the difference of each y.
void fly(Motion &motion, const Clock &clock, const Instant &target, PerCoordinate &change);

// Displacement and velocity of a mass, counted from 0. The displacement is clamped to the stops.
double displacement(const Motion &motion, std::size_t mass);
double velocity(const Motion &motion, std::size_t mass);

// (3) of a contact: its gap or hold force.
inline double evaluate(const Contact &contact, const Motion &motion) {
  double sum = contact.offset + dot(contact.row, motion.y);
  if (contact.held)
    sum +=
        contact.damping * dot(contact.row, motion.dy) +
        (contact.forcing.real() * motion.turn.real() - contact.forcing.imag() * motion.turn.imag());
  return sum;
}

// The sum of the moduli of the terms of (3), which is the scale of its rounding.
double terms_of(const Contact &contact, const Motion &motion);
// The speed of a gap.
inline double gap_speed(const Contact &contact, const Motion &motion) {
  return dot(contact.row, motion.dy);
}

// True when (3) exceeds `gap_reread_ratio` times the sum of the moduli of its terms. Smaller gaps
// lose more bits to cancellation and are carried from event to event.
bool is_resolved(const Contact &contact, const Motion &motion);

// Sets the displacements and velocities of all masses. A small gap is that of the stop, which is
// carried, and not that of the coordinates.
void set_state(const Motion &motion, const std::vector<StopState> &stops, const Scene &scene,
               MotionState &state);

// The force, towards the stop of a contact, that acts on its mass if the mass is at rest there.
double pressing_force(const Scene &scene, const Contact &contact, const Motion &motion);

}  // namespace vibro_impact::detail
