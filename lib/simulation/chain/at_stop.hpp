// What is known of a stop beside the lanes, and the one place where that is set: of what is watched
// there, the gap of a free mass or the force that presses a held one into the stop, the first
// `zeros` derivatives are zero exactly, and those that follow are these.
#pragma once

namespace vibro_impact {

struct AtStop {
  int zeros = 0;
  // Of a free mass in flight, carried on their own because reading a small gap off the lanes loses
  // it to cancellation. With one zero, after an impact, the speed follows; with more, both are 0.
  double gap = 0.0, speed = 0.0;
  // The derivative that follows the zeros where a mass leaves from rest or is held, in units of the
  // rate of the scene; positive, or 0 where it is not known.
  double leading = 0.0;
  bool below_rounding = false;  // the gap, of what the lanes tell
  double last_speed = 0.0;      // of the latest impact
  int falling = 0;              // as in Event
};

// More zeros than any expansion has terms: no force acts on a mass at rest, to all orders.
constexpr int all_zeros = 1000;

// In flight, with this gap and speed. Of a mass held: nothing is known but that it is.
inline void set_in_flight(AtStop &stop, double gap = 0.0, double speed = 0.0) {
  stop = {0, gap, speed, 0.0, false, stop.last_speed, stop.falling};
}

// Just after an impact: the gap is zero, and this is its speed.
inline void set_leaving(AtStop &stop, double speed) {
  stop = {1, 0.0, speed, 0.0, false, stop.last_speed, stop.falling};
}

// At rest at the stop, held or let go at this instant.
inline void set_at_rest(AtStop &stop, int zeros, double leading) {
  stop = {zeros, 0.0, 0.0, leading, false, stop.last_speed, stop.falling};
}

// True where more is known than a gap and its speed, or than that the mass is held.
inline bool is_known(const AtStop &stop) {
  return stop.zeros > 0 || stop.leading > 0.0;
}

// Of a free mass: it leaves its stop from rest.
inline bool leaves_from_rest(const AtStop &stop) {
  return stop.zeros >= 2;
}

// Of a free mass: no force acts on it, to all orders.
inline bool stays_at_rest(const AtStop &stop) {
  return stop.zeros == all_zeros;
}

// The force is zero at this instant; on a free mass it is the second derivative of the gap.
inline bool force_is_zero(const AtStop &stop, bool held) {
  return stop.zeros > (held ? 0 : 2);
}

// More is zero than at a root of a force: motion has yet to come along the chain.
inline bool is_still(const AtStop &stop) {
  return stop.zeros > 3;
}

}  // namespace vibro_impact
