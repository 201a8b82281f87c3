// An impact in the lanes: Eqs. 8-11 as Psi^-1 R Psi (Eq. 16).
#pragma once

#include "simulation/chain/motion.hpp"

namespace vibro_impact {

// Brings the lanes into agreement with a gap that is zero exactly and has the speed given.
template <int D>
void place_at_stop(State<D> &state, const Contact<D> &contact, double speed) {
  const ContactMode<D> &mode = *state.mode;
  const double misplaced = watched_now(state, contact);
  const double misdirected = speed - (contact.watched.on_value * state.slope).sum();
  const auto i = static_cast<Eigen::Index>(contact.mass);
  state.value += mode.to_modal.col(i).array() * (contact.sigma * misplaced);
  if (mode.any_decay) state.value += contact.jump_value * misdirected;
  state.slope += contact.jump_slope * misdirected;
  tie_decays(state);
}

// Leaves the mass at its stop with this gap speed, which is kept to full relative accuracy beside
// the lanes. A stop across sees the same jump.
template <int D>
void leave_stop(State<D> &state, const Contact<D> &contact, double leaving) {
  place_at_stop(state, contact, leaving);
  set_in_flight(state.stops[contact.stop], 0.0, leaving);
  for (const Contact<D> &other : state.mode->contacts)
    if (other.mass == contact.mass && other.stop != contact.stop)
      state.stops[other.stop].speed = -leaving;
}

// Time to the next impact at a stop that the mass has just left, to leading order, where a
// constant force presses it; infinite where none does.
template <int D>
double next_flight(const State<D> &state, const Scene &scene, const Contact<D> &contact) {
  const double press = contact.press(state.value, state.slope);
  return press > 0.0 ? 2.0 * state.stops[contact.stop].speed * scene.mass[contact.mass] / press
                     : std::numeric_limits<double>::infinity();
}

}  // namespace vibro_impact
