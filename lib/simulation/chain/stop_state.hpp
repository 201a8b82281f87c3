// What a run knows of a stop beside the modal coordinates.
#pragma once

#include <optional>
#include <variant>

#include "vibro_impact/instant.hpp"

namespace vibro_impact::detail {

// A mass in flight before its stop. Gap and gap speed are carried on their own, because a small gap
// evaluated from the modal coordinates is lost to cancellation. A gap of 0 is exact, as after an
// impact.
struct InFlight {
  double gap = 0.0, speed = 0.0;
  bool below_rounding = false;  // the gap lies below the rounding of the modal coordinates
};

// The first derivative that is not zero of what keeps a mass at rest, or takes it away: of the
// force that presses a held mass, or of the acceleration of the gap of a released one. `zeros`
// lower derivatives are exactly zero. The value is positive, in units of powers of the rate bound
// of the scene; 0: no force acts, to all orders, and the mass stays where it is.
struct LeadingDerivative {
  int zeros = 0;
  double value = 0.0;
};

// A mass at rest at its stop: held there, or released at this instant, or resting there free of any
// force. `decided` stands from the instant at which the force was decided until time passes.
//
// `postponed`: the decision would be the second change at one instant of the clock, so close is it
// to the first. It is made again one rounding of the clock later.
struct AtRest {
  std::optional<LeadingDerivative> decided = {};
  bool postponed = false;
};

struct StopState {
  std::variant<InFlight, AtRest> contact = InFlight{};
  double last_speed = 0.0;              // closing speed of the latest impact
  int falling = 0;                      // as in Event
  std::optional<Instant> changed = {};  // the latest stick or release
};

inline bool is_postponed(const StopState &stop) {
  const auto *rest = std::get_if<AtRest>(&stop.contact);
  return rest != nullptr && rest->postponed;
}

// True when no force acts on the mass, to all orders: it stays where it is, free.
inline bool rests_without_force(const StopState &stop) {
  const auto *rest = std::get_if<AtRest>(&stop.contact);
  return rest != nullptr && rest->decided && rest->decided->value == 0.0;
}

}  // namespace vibro_impact::detail
