// Where a run stands: the physical state a user sees, and the state the pipeline carries.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <vector>

#include "contact_mode.hpp"
#include "flow.hpp"
#include "instant.hpp"

namespace vibro_impact {

// Time, displacement and velocity of every mass, and the contact mode. Non-dimensional.
struct MotionState {
  Instant instant;
  Eigen::VectorXd displacement, velocity;  // N
  Held held;                               // N
};

// What is known of a stop beside the lanes. For the stop of a free mass: its gap and gap speed,
// carried on their own because reading a small gap off the lanes loses it to cancellation; and how
// many leading derivatives of the gap are zero by definition (1 after an impact, 2 after a release
// by a jump, 3 after a release at a root of the hold force), with the next one, `leading`. For the
// stop of a held mass: the same zeros of the hold force (1 where the force just grazed zero).
struct StopState {
  double gap = 0.0, speed = 0.0;
  int zeros = 0;
  double leading = 0.0;
};

template <int D>
struct State {
  using Lanes = Eigen::Array<double, D, 1>;
  Instant now;
  const ContactMode<D> *mode = nullptr;
  Lanes value, slope;
  std::vector<StopState> stops;  // one per stop of the scene
};

// Sets the forcing lanes cos(Omega t), sin(Omega t) from the phase.
template <int D>
void set_forcing(State<D> &state, const Scene &scene) {
  if (!scene.forced()) return;
  const Eigen::Index c = state.mode->lanes() - 2, s = c + 1;
  const double angle = scene.omega * state.now.phase;
  state.value(c) = std::cos(angle);
  state.value(s) = std::sin(angle);
  state.slope(c) = -scene.omega * state.value(s);
  state.slope(s) = scene.omega * state.value(c);
}

// The lanes tau later, in closed form: one modal evaluation.
template <int D>
void flow(const ContactMode<D> &mode, const Scene &scene, const Eigen::Array<double, D, 1> &value,
          const Eigen::Array<double, D, 1> &slope, double tau,
          Eigen::Array<double, D, 1> &value_after, Eigen::Array<double, D, 1> &slope_after) {
  value_after.resize(value.size());
  slope_after.resize(value.size());
  for (Eigen::Index j = 0; j < mode.lanes(); ++j) {
    auto after = free_response(mode.kappa(j), mode.lambda(j),
                               OscillatorState<double>{value(j), slope(j)}, tau);
    if (mode.resonant(j) != 0.0) {
      const Eigen::Index c = mode.lanes() - 2;
      const auto added =
          forced_from_rest(mode.kappa(j), mode.lambda(j),
                           mode.resonant(j) * std::complex<double>(value(c), value(c + 1)),
                           scene.omega, tau);
      after.value += added.value;
      after.slope += added.slope;
    }
    value_after(j) = after.value;
    slope_after(j) = after.slope;
  }
}

template <int D>
bool opposite_is_nearer(const State<D> &state, const ContactMode<D> &mode, const OpenStop<D> &open) {
  for (const OpenStop<D> &other : mode.open)
    if (other.mass == open.mass && state.stops[other.stop].gap < state.stops[open.stop].gap)
      return true;
  return false;
}

// Displacements and velocities of all masses. A mass with a stop is placed by its carried gap, one
// with two stops by the narrower.
template <int D>
MotionState physical(const State<D> &state, const Scene &scene) {
  const ContactMode<D> &mode = *state.mode;
  MotionState motion{state.now, mode.equilibrium + mode.shape * state.value.matrix(),
                     mode.shape * state.slope.matrix(), mode.held};
  for (const OpenStop<D> &open : mode.open) {
    const StopState &stop = state.stops[open.stop];
    const double sigma = sign(scene.stops[open.stop].side);
    const auto i = static_cast<Eigen::Index>(open.mass);
    if (opposite_is_nearer(state, mode, open)) continue;
    motion.displacement(i) = scene.stops[open.stop].position - sigma * stop.gap;
    motion.velocity(i) = -sigma * stop.speed;
  }
  return motion;
}

// Expresses a physical state in the lanes of `mode`; the stop states are left to the caller.
template <int D>
void set_lanes(State<D> &state, const Scene &scene, const ContactMode<D> &mode,
               const MotionState &motion) {
  state.mode = &mode;
  state.value = (mode.to_modal * (motion.displacement - mode.equilibrium)).array();
  state.slope = (mode.to_modal * motion.velocity).array();
  if (!scene.forced()) return;
  set_forcing(state, scene);
  const Eigen::Index c = mode.lanes() - 2;
  state.value -= mode.steady_cos * state.value(c) + mode.steady_sin * state.value(c + 1);
  state.slope -= mode.steady_cos * state.slope(c) + mode.steady_sin * state.slope(c + 1);
}

}  // namespace vibro_impact
