// Where a run stands between events, in the modal coordinates of its contact mode.
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
  // The motion stands at `now` plus `now_rest`, which lies below the rounding of the phase: steps
  // add up without rounding, also where the phase cannot resolve them.
  Instant now;
  double now_rest = 0.0;
  std::complex<double> turn;  // e^(i Omega t)
  const ContactMode *mode = nullptr;
  PerCoordinate y, dy;
  // True of a coordinate whose own motion has died out: it follows its steady response. Of a
  // contact mode that is stiff; else empty.
  std::vector<char> following;
  // The slow coordinates are not summed up from step to step, because hardly anything pulls back
  // what a sum rounds. They are evaluated from the latest change of the motion at one instant.
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

// Ties what depends on the rest after a move: the slopes of decays, coordinates that follow their
// steady response, and the rigid-body mode.
void complete_move(Motion &motion, const Clock &clock);

// Ties the slopes of decays after a change at one instant, wakes all coordinates, and takes the
// rigid-body mode from there on.
void complete_change(Motion &motion);

// Lets damped coordinates follow their steady response once their deviation from it has died out:
// it takes part neither in the acceleration nor in the displacement beyond the rounding of the
// rest, or of the response. A stiff scene then moves at the pace of what is still in motion.
void let_dead_coordinates_follow(Motion &motion, double omega);

// The largest rate of what is in motion.
double rate_in_motion(const Motion &motion);

// Moves to `target`, in closed form. `change` is set to what that adds to each y.
void fly(Motion &motion, const Clock &clock, const Instant &target, PerCoordinate &change);

// Of a mass, counted from 0. Rounding puts no mass beyond its stops.
double displacement(const Motion &motion, std::size_t mass);
double velocity(const Motion &motion, std::size_t mass);

// (3) of a contact now, a gap or a hold force.
inline double evaluate(const Contact &contact, const Motion &motion) {
  double sum = contact.offset + dot(contact.row, motion.y);
  if (contact.held)
    sum +=
        contact.damping * dot(contact.row, motion.dy) +
        (contact.forcing.real() * motion.turn.real() - contact.forcing.imag() * motion.turn.imag());
  return sum;
}

// The sum of the moduli of what that adds up: the scale of its rounding.
double terms_of(const Contact &contact, const Motion &motion);
// The speed of a gap.
inline double gap_speed(const Contact &contact, const Motion &motion) {
  return dot(contact.row, motion.dy);
}

// True when few bits of (3) are lost to cancellation. Smaller gaps are carried from event to event.
bool is_resolved(const Contact &contact, const Motion &motion);

// Sets the motion of all masses. A free mass in a small gap is placed by the carried one.
void set_state(const Motion &motion, const std::vector<StopState> &stops, const Scene &scene,
               MotionState &state);

// Sets how far these displacements, and velocities in units of `rate`, may be off by rounding: that
// of the largest of them, in which all coordinates have had a share.
void set_rounding(const Motion &motion, const Scene &scene, double rate,
                  std::vector<double> &error);

// The force that would press a mass into its stop if it were at rest there.
double pressing_force(const Scene &scene, const Contact &contact, const Motion &motion);

}  // namespace vibro_impact::detail
