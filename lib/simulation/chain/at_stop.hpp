// What is known of a stop beside the lanes.
#pragma once

#include "vibro_impact/instant.hpp"

namespace vibro_impact {

struct AtStop {
  // Of a free mass in flight, carried on their own because reading a small gap off the lanes loses
  // it to cancellation; a gap of 0 is exact, as after an impact. Both 0 of a mass at rest.
  double gap = 0.0, speed = 0.0;
  bool below_rounding = false;  // the gap lies below the rounding of the lanes
  // Where it has just been decided whether a mass at rest is held or let go: of the force that
  // keeps it there or takes it away, the first `zeros` derivatives are zero exactly, and `leading`
  // > 0 is the next, in units of the rate of the scene (of a mass let go, of its acceleration);
  // `leading` = 0: no force acts, to all orders.
  bool decided = false;
  int zeros = 0;
  double leading = 0.0;
  double last_speed = 0.0;  // of the latest impact
  int falling = 0;          // as in Event
  // The latest instant at which the force on the mass, at rest here, was exactly zero.
  Instant force_was_zero{0, -1.0};
};

// In flight, with this gap and speed. Of a mass held: nothing is known but that it is.
inline void set_in_flight(AtStop &stop, double gap = 0.0, double speed = 0.0) {
  stop = {gap, speed, false, false, 0, 0.0, stop.last_speed, stop.falling, stop.force_was_zero};
}

// At rest at the stop, held or let go at this instant.
inline void set_at_rest(AtStop &stop, int zeros, double leading) {
  stop = {
      0.0, 0.0, false, true, zeros, leading, stop.last_speed, stop.falling, stop.force_was_zero};
}

// No force acts on the mass, to all orders: it stays where it is, free.
inline bool stays_at_rest(const AtStop &stop) {
  return stop.decided && stop.leading == 0.0;
}

}  // namespace vibro_impact
