// The state of a stop, which a run carries in addition to the modal coordinates.
#pragma once

#include <optional>

#include "vibro_impact/instant.hpp"

namespace vibro_impact::detail {

// The decision about a mass at rest: the derivatives of order 0, ..., zeros - 1 of the hold force
// of a held mass, or of the acceleration g'' of the gap of a released mass, are exactly zero, and
// the next one is positive. With `none` no force acts on the mass, to all orders, and the mass
// stays free and at rest at its stop.
struct DecidedForce {
  int zeros = 0;
  bool none = false;
};

// A mass before its stop, or at it:
//   in flight                      {}
//   at an impact, or stopped by it {.speed = g'}, or 0
//   at rest, not yet decided       {.at_rest}
//   held                           {.at_rest, .decided}, later {.at_rest}
//   released at this instant       {.at_rest, .decided, .released}
//   free without any force         {.at_rest, .decided} with DecidedForce::none
//   held or free as before         {.at_rest, .postponed}
struct AtStop {
  bool at_rest = false;
  // The gap speed g' of a mass in flight whose gap g = sigma (s - x) is exactly 0, just before an
  // impact and then just after. At other times both are evaluated from the modal coordinates.
  std::optional<double> speed = {};
  // The force decided at this instant on a mass at rest. It is reset when time passes, unless no
  // force acts.
  std::optional<DecidedForce> decided = {};
  bool released = false;  // the mass at rest leaves when time passes
  // A mass cannot stick and be released at one instant of the clock. The second of two such
  // decisions is made again one rounding of the clock later.
  bool postponed = false;
};

struct StopState {
  AtStop contact = {};
  double last_speed = 0.0;              // closing speed of the latest impact
  int falling = 0;                      // see Event::falling
  std::optional<Instant> changed = {};  // instant of the latest stick or release
  Instant left = {};                    // instant of the start, of the latest release or impact
  // The time in which the falling impacts happen: the longest of their flights and of their times
  // to the limit, to leading order. It is the unit of time where every rate is slower.
  double duration = 0.0;
};

// True when no force acts on the mass, to all orders.
inline bool rests_without_force(const StopState &stop) {
  return stop.contact.decided && stop.contact.decided->none;
}

}  // namespace vibro_impact::detail
