// Chatters among the events of a run, and the border orbit: where a chatter just fails to complete.
// Border orbits are found by point_of (bifurcation_curve.hpp).
#pragma once

#include <vector>

#include "vibro_impact/record.hpp"

namespace vibro_impact {

// Impacts of a mass at one stop, each slower than the one before.
struct Chatter {
  std::size_t stop = 0;              // index in Scene::stops
  std::vector<std::size_t> impacts;  // which of the events they are
  bool complete = false;             // it ends in sticking
};

// All chatters among the events of a run, in the order in which they begin. A single impact is one.
std::vector<Chatter> chatters_of(const std::vector<Event> &events);

// On a border orbit the accumulation point of the chatter is also the zero of the pressing force.
// With v the speed after an impact, a the pressing acceleration there and b = -a' > 0, the flight s
// (in units of a / b) that follows obeys v b / a^2 = s/2 - s^2/6, and the chatter is self-similar
// where the next impact has the same v b / a^2:
//   (3 - s) (1 - s)^2 = r (3 - 2 s).
// Pressing force and speed then fall by the factors below; the fixed point repels the neighbouring
// orbits by `escape` per impact: a chatter that completes turns towards speed ratio r, one that
// does not falls below the ratio of the border orbit, and its mass is let go. Beyond the border,
// where it is let go after finitely many impacts, one more takes a distance smaller by 1 / escape.
struct BorderChatter {
  double flight = 0.0;       // s
  double press_ratio = 0.0;  // 1 - s
  double speed_ratio = 0.0;  // (1 - s)^2
  double escape = 0.0;
};

// Throws std::invalid_argument unless 0 < r < 1.
BorderChatter border_chatter(double r);

}  // namespace vibro_impact
