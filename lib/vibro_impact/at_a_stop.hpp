// What happens at a stop: sticking, release by a root or a jump of the hold force, coming to rest.
#pragma once

#include "impact.hpp"
#include "run.hpp"
#include "sticking.hpp"

namespace vibro_impact::detail {

template <int D>
void stick_at(Run<D> &run, std::size_t stop) {
  stick(run.state, run.scene, run.modes, stop, run.counters);
  run.falling[stop] = 0;
  run.chatter.together.clear();
  run.flight_guess = std::numeric_limits<double>::infinity();  // the bounces expected are over
  emit(run, EventKind::stick, stop, 0.0, 0.0, false);
}

template <int D>
void release_at(Run<D> &run, std::size_t stop, int zeros, double leading) {
  release(run.state, run.scene, run.modes, stop, zeros, leading, run.counters);
  run.chatter.together.clear();
  run.last_speed[stop] = 0.0;
  emit(run, EventKind::release, stop, 0.0, 0.0, zeros == 2);
}

// A mass at rest at its stop: it sticks when pressed, else leaves with the acceleration it has.
// Where the force is zero its rate decides, known to the next expansion as the third derivative of
// the gap.
template <int D>
void settle(Run<D> &run, std::size_t stop) {
  const OpenStop<D> &open = open_stop(run.state, stop);
  const double press = open.press(run.state.value, run.state.slope);
  const double mass = run.scene.mass[open.mass];
  if (press > 0.0) {
    stick_at(run, stop);
  } else if (press < 0.0) {
    run.state.stops[stop] = {0.0, 0.0, 2, -press / mass};
  } else {
    const auto curvature = curvature_of(*run.state.mode, run.state.value, run.state.slope);
    run.state.stops[stop] = {0.0, 0.0, 3, -rate_of(open.press, run.state.slope, curvature) / mass};
  }
}

// A neighbour's impact at the very instant at which a mass is about to leave its stop from rest:
// the damper between them changes the acceleration it leaves with, or presses it back.
template <int D>
void settle_beside(Run<D> &run, std::size_t mass) {
  for (std::size_t k = 0; k < run.scene.stops.size(); ++k) {
    const auto other = static_cast<std::size_t>(run.scene.stops[k].mass - 1);
    const bool neighbour = other + 1 == mass || mass + 1 == other;
    if (neighbour && run.state.mode->held[other] == 0 && run.state.stops[k].zeros >= 2)
      settle(run, k);
  }
}

// A neighbour's impact makes the hold force jump; where it changes sign the mass leaves at once.
template <int D>
void release_by_jump(Run<D> &run, std::size_t mass) {
  for (std::size_t k = 0; k < run.state.mode->closed.size();) {
    const ClosedStop<D> &closed = run.state.mode->closed[k];
    const std::size_t distance = closed.mass > mass ? closed.mass - mass : mass - closed.mass;
    const double press = distance == 1 ? closed.press(run.state.value, run.state.slope) : 0.0;
    if (press < 0.0) {
      release_at(run, closed.stop, 2, -press / run.scene.mass[closed.mass]);
      k = 0;  // the contact mode has changed
    } else {
      ++k;
    }
  }
}

// What impacts at `stops` lead to at once, beside themselves.
template <int D>
void settle_after(Run<D> &run, const std::vector<std::size_t> &stops) {
  for (std::size_t stop : stops)
    if (run.state.stops[stop].speed == 0.0) settle(run, stop);
  if (!(run.scene.beta > 0.0)) return;
  for (std::size_t stop : stops)
    settle_beside(run, static_cast<std::size_t>(run.scene.stops[stop].mass - 1));
  for (std::size_t stop : stops)
    release_by_jump(run, static_cast<std::size_t>(run.scene.stops[stop].mass - 1));
}

}  // namespace vibro_impact::detail
