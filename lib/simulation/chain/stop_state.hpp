// The exact knowledge of a stop at an instant. A flight forgets it, but for `Postponed`, and for
// `Forceless` while the gap is zero. A long flight forgets these, too.
#pragma once

#include <optional>
#include <variant>

#include "twofold_instant.hpp"
#include "vibro_impact/event.hpp"

namespace vibro_impact::detail {

// The mass is free and at rest at the stop, and not yet decided.
struct Resting {};
// The derivatives of order 0, ..., zeros - 1 of what is evaluated at the contact, the gap of a free
// mass or the force on a held one, are exactly zero. The next one is positive: after an impact the
// speed, after a decision the derivative that has decided, of the order z of the force:
//
//   gap after an impact     1 zero         the speed
//   gap after a release     z + 2 zeros    the derivative of order z of x''
//   force after a stick     z zeros        the derivative of order z of the force
//
// Without zeros nothing is known but the motion.
struct ExactZeros {
  int zeros = 0;
  double derivative = 0.0;  // of order `zeros`
};
// No force above the threshold of zero acts on the mass, to all orders. It is free, and stays at
// rest at the stop until its gap is seen.
struct Forceless {};
// A mass neither sticks nor is released at the instant of the latest of these events. The decision
// is made again at a later instant of the clock.
struct Postponed {};

using AtStop = std::variant<ExactZeros, Resting, Forceless, Postponed>;

template <class State>
bool is(const AtStop &at) {
  return std::holds_alternative<State>(at);
}

// True of a contact that no flight searches: it stays as it is until its decision is made again.
inline bool is_idle(const AtStop &at) {
  return is<Forceless>(at) || is<Postponed>(at);
}

struct StopState {
  AtStop at = {};
  double last_speed = 0.0;              // closing speed of the latest impact
  double first_speed = 0.0;             // of the impact from which speeds fall
  int falling = 0;                      // see Event::falling
  TwofoldInstant since = {};            // instant of the impact from which speeds fall
  std::optional<Instant> changed = {};  // instant of the latest stick or release
  // Of impacts of a chatter that the event at its limit will report.
  ImpactSum unreported = {};
};

}  // namespace vibro_impact::detail
