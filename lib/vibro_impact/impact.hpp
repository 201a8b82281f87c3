// The impact law: Newton's coefficient of restitution (Eqs. 8-11).
#pragma once

#include "motion.hpp"

namespace vibro_impact {

// Brings the lanes into agreement with a gap that is zero exactly and has the speed given.
template <int D>
void place_at_stop(State<D> &state, const Scene &scene, const OpenStop<D> &open, double speed) {
  const double sigma = sign(scene.stops[open.stop].side);
  const double misplaced = open.gap(state.value, state.slope);
  const double misdirected = speed - (open.gap.on_value * state.slope).sum();
  const auto i = static_cast<Eigen::Index>(open.mass);
  state.value += state.mode->to_modal.col(i).array() * (sigma * misplaced);
  state.slope -= state.mode->to_modal.col(i).array() * (sigma * misdirected);
  if (state.mode->any_decay) {
    state.value -= state.mode->velocity_to_modal.col(i).array() * (sigma * misdirected);
    tie_decays(state);
  }
}

// x_i' -> -r x_i' for the mass at stop `k`, in the lanes (Psi^-1 R Psi restricted to one mass; for
// several masses at one instant the factors commute and their product is the R of Eq. 16).
// `closing` is the gap speed just before, <= 0. The gap speed afterwards is kept to full relative
// accuracy in the stop state.
template <int D>
void apply_impact(State<D> &state, const Scene &scene, const OpenStop<D> &open, double closing) {
  const double leaving = -scene.restitution * closing;
  place_at_stop(state, scene, open, leaving);
  state.stops[open.stop] = {0.0, leaving, 1, leaving};
  for (const OpenStop<D> &other : state.mode->open)  // an opposite stop sees the same jump
    if (other.mass == open.mass && other.stop != open.stop)
      state.stops[other.stop].speed = -leaving;
}

}  // namespace vibro_impact
