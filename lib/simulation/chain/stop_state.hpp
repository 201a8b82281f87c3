// The state of a stop, which a run carries in addition to the modal coordinates.
#pragma once

#include <optional>
#include <variant>

#include "vibro_impact/instant.hpp"

namespace vibro_impact::detail {

// A mass in flight before its stop. Gap g = sigma (s - x) and gap speed g' are carried, because a
// small gap evaluated from the modal coordinates loses its digits to cancellation. After an impact
// the gap is exactly 0.
struct InFlight {
  double gap = 0.0, speed = 0.0;
  bool below_rounding = false;  // the gap lies below the rounding of the modal coordinates
};

// The first non-zero time derivative of w: w is the hold force of a held mass, or the acceleration
// g'' of the gap of a released mass. The derivatives of order 0, ..., zeros - 1 are exactly zero,
// and the next one is value * rate_bound^zeros with value > 0. With value = 0 no force acts on the
// mass, to all orders, and the mass stays free and at rest at its stop.
struct LeadingDerivative {
  int zeros = 0;
  double value = 0.0;
};

// A mass at rest at its stop: held, or released at this instant, or free without any force.
struct AtRest {
  // The force decided at this instant. It is reset when time passes.
  std::optional<LeadingDerivative> decided = {};
  // A mass cannot stick and be released at one instant of the clock. The second of two such
  // decisions is made again one rounding of the clock later.
  bool postponed = false;
};

struct StopState {
  std::variant<InFlight, AtRest> contact = InFlight{};
  double last_speed = 0.0;              // closing speed of the latest impact
  int falling = 0;                      // see Event::falling
  std::optional<Instant> changed = {};  // instant of the latest stick or release
};

inline bool is_postponed(const StopState &stop) {
  const auto *rest = std::get_if<AtRest>(&stop.contact);
  return rest != nullptr && rest->postponed;
}

// The force decided at this instant on a mass at rest, or nullptr.
inline const LeadingDerivative *decided_force(const StopState &stop) {
  const auto *rest = std::get_if<AtRest>(&stop.contact);
  return rest != nullptr && rest->decided ? &*rest->decided : nullptr;
}

// True when no force acts on the mass, to all orders.
inline bool rests_without_force(const StopState &stop) {
  const LeadingDerivative *leading = decided_force(stop);
  return leading != nullptr && leading->value == 0.0;
}

// Gap and gap speed: the carried ones of a mass in flight, and zero of a mass at rest.
inline InFlight flight_of(const StopState &stop) {
  const auto *flight = std::get_if<InFlight>(&stop.contact);
  return flight != nullptr ? *flight : InFlight{};
}
inline double gap_of(const StopState &stop) {
  return flight_of(stop).gap;
}
inline double speed_of(const StopState &stop) {
  return flight_of(stop).speed;
}

}  // namespace vibro_impact::detail
