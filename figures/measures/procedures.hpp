// The ways in which the author's program may have followed the motion, and what they make of the
// statements of the paper that differ from ours.
//
// The library computes the motion where impacts are located. There a procedure only changes when a
// mass is held, or the equation of motion while mass 2 sticks. A procedure with fixed steps is
// followed by the exponential of the linear system. All quantities are non-dimensional.
#pragma once

#include <vector>

#include "vibro_impact/vibro_impact.hpp"

namespace vibro_impact::figures {

// With the defaults the motion is the exact one.
struct Procedure {
  // A pressed mass sticks after a flight shorter than this, or after an impact slower than this.
  double shortest_flight = 0.0, slowest_impact = 0.0;
  // A mass without a pressing force sticks, too, unless the force pulls it off: F >= 0.
  bool holds_without_force = false;
  // While mass 2 sticks, mass 1 moves about -s2/2, as Eq. 24 is printed, instead of about +s2/2.
  bool printed_equation24 = false;
  // With a positive step nothing is located. An impact acts at the first step at which the mass is
  // beyond its stop, and the mass is put back on the stop. A release acts at the first step at
  // which the mass is not pressed.
  double step = 0.0;
};

// Fixed steps, with a pressed mass held after a flight of at most so many steps.
inline Procedure in_steps(double step, int cut_off = 10) {
  return {.shortest_flight = (cut_off + 0.5) * step, .step = step};
}

// Events, and the state at the end.
struct FollowedMotion {
  std::vector<Event> events;
  MotionState state;
};

// The motion of two masses with a stop each, from a start to a time, by the procedure. Fixed steps
// begin at the phase zero with no mass held. Throws std::invalid_argument as `simulate` does, and
// std::runtime_error when a run is given up.
FollowedMotion follow(Scene scene, MotionState state, double until, const Procedure &procedure);

}  // namespace vibro_impact::figures
