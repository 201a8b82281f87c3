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
void set_forcing(const ContactMode<D> &mode, const Scene &scene, double phase,
                 Eigen::Array<double, D, 1> &value, Eigen::Array<double, D, 1> &slope) {
  if (mode.forcing_lanes == 0) return;
  const Eigen::Index c = mode.lanes() - 2, s = c + 1;
  const double angle = scene.omega * phase;
  value(c) = std::cos(angle);
  value(s) = std::sin(angle);
  slope(c) = -scene.omega * value(s);
  slope(s) = scene.omega * value(c);
}

template <int D>
void set_forcing(State<D> &state, const Scene &scene) {
  set_forcing(*state.mode, scene, state.now.phase, state.value, state.slope);
}

// The forcing lanes a short time later, by the addition theorem: rounding adds up over the flights
// of one chatter only.
template <int D>
void turn_forcing(State<D> &state, const Scene &scene, double tau) {
  const ContactMode<D> &mode = *state.mode;
  if (mode.forcing_lanes == 0) return;
  const double angle = scene.omega * tau, w = angle * angle;
  if (w > 0x1p-4) return set_forcing(state, scene);
  // Taylor, to below rounding.
  constexpr double s3 = 1 / 6.0, s5 = 1 / 120.0, s7 = 1 / 5040.0, s9 = 1 / 362880.0,
                   s11 = 1 / 39916800.0;
  constexpr double c2 = 1 / 2.0, c4 = 1 / 24.0, c6 = 1 / 720.0, c8 = 1 / 40320.0,
                   c10 = 1 / 3628800.0, c12 = 1 / 479001600.0;
  const double ww = w * w;
  const double sine = angle - angle * w * ((s3 - w * s5) + ww * ((s7 - w * s9) + ww * s11));
  const double versine = w * ((c2 - w * c4) + ww * ((c6 - w * c8) + ww * (c10 - w * c12)));
  const Eigen::Index c = mode.lanes() - 2, s = c + 1;
  const double cosine_now = state.value(c), sine_now = state.value(s);
  state.value(c) -= versine * cosine_now + sine * sine_now;
  state.value(s) -= versine * sine_now - sine * cosine_now;
  state.slope(c) = -scene.omega * state.value(s);
  state.slope(s) = scene.omega * state.value(c);
}

// Lanes that are pure decays have y' = -kappa y.
template <int D>
void tie_decays(State<D> &state) {
  if (!state.mode->any_decay) return;
  for (Eigen::Index j = 0; j < state.mode->lanes(); ++j)
    if (state.mode->decay(j)) state.slope(j) = -state.mode->kappa(j) * state.value(j);
}

// Drops the damped lanes that have died out: those whose share in the acceleration lies far below
// the rounding of the whole. A stiff scene then moves at the pace of what is still in motion.
template <int D>
void drop_dead_lanes(State<D> &state) {
  const ContactMode<D> &mode = *state.mode;
  if (!mode.stiff) return;
  const Eigen::Array<double, D, 1> share =
      mode.extent * mode.rate * (mode.rate * state.value.abs() + state.slope.abs());
  const double dead = 0x1p-62 * share.sum();
  for (Eigen::Index j = 0; j < mode.lanes(); ++j)
    if (mode.kappa(j) > 0.0 && mode.resonant(j) == 0.0 && share(j) <= dead)
      state.value(j) = state.slope(j) = 0.0;
}

// Rate of the fastest lane that is in motion.
template <int D>
double fastest_in_motion(const ContactMode<D> &mode, const Eigen::Array<double, D, 1> &value,
                         const Eigen::Array<double, D, 1> &slope) {
  if (!mode.stiff) return mode.fastest;
  double fastest = 0.0;
  for (Eigen::Index j = 0; j < mode.lanes(); ++j)
    if (value(j) != 0.0 || slope(j) != 0.0 || mode.resonant(j) != 0.0)
      fastest = std::max(fastest, mode.rate(j));
  return fastest;
}

// The lanes tau later, in closed form: one modal evaluation.
template <int D>
void flow(const ContactMode<D> &mode, const Scene &scene, const Eigen::Array<double, D, 1> &value,
          const Eigen::Array<double, D, 1> &slope, double tau,
          Eigen::Array<double, D, 1> &value_after, Eigen::Array<double, D, 1> &slope_after) {
  value_after.resize(value.size());
  slope_after.resize(value.size());
  for (Eigen::Index j = 0; j < mode.lanes(); ++j) {
    if (mode.decay(j)) {
      value_after(j) = value(j) * std::exp(-mode.kappa(j) * tau);
      slope_after(j) = -mode.kappa(j) * value_after(j);
      continue;
    }
    auto after = free_response(mode.kappa(j), mode.lambda(j),
                               OscillatorState<double>{value(j), slope(j)}, tau);
    if (mode.resonant(j) != 0.0) {
      const Eigen::Index c = mode.lanes() - 2;
      const auto added = forced_from_rest(
          mode.kappa(j), mode.lambda(j),
          mode.resonant(j) * std::complex<double>(value(c), value(c + 1)), scene.omega, tau);
      after.value += added.value;
      after.slope += added.slope;
    }
    value_after(j) = after.value;
    slope_after(j) = after.slope;
  }
}

template <int D>
bool opposite_is_nearer(const State<D> &state, const ContactMode<D> &mode,
                        const OpenStop<D> &open) {
  for (const OpenStop<D> &other : mode.open)
    if (other.mass == open.mass && state.stops[other.stop].gap < state.stops[open.stop].gap)
      return true;
  return false;
}

// Displacements and velocities of all masses.
template <int D>
struct Masses {
  Eigen::Matrix<double, ContactMode<D>::masses, 1> displacement, velocity;
};

// A mass with a stop is placed by its carried gap, one with two stops by the narrower.
template <int D>
Masses<D> masses_of(const State<D> &state, const Scene &scene) {
  const ContactMode<D> &mode = *state.mode;
  Masses<D> masses{mode.equilibrium + mode.shape * state.value.matrix(),
                   mode.shape * state.slope.matrix()};
  for (const OpenStop<D> &open : mode.open) {
    const StopState &stop = state.stops[open.stop];
    const double sigma = sign(scene.stops[open.stop].side);
    const auto i = static_cast<Eigen::Index>(open.mass);
    if (opposite_is_nearer(state, mode, open)) continue;
    masses.displacement(i) = scene.stops[open.stop].position - sigma * stop.gap;
    masses.velocity(i) = -sigma * stop.speed;
  }
  return masses;
}

template <int D>
MotionState physical(const State<D> &state, const Scene &scene) {
  const Masses<D> masses = masses_of(state, scene);
  return {state.now, masses.displacement, masses.velocity, state.mode->held};
}

// y'' of every lane.
template <int D>
Eigen::Array<double, D, 1> curvature_of(const ContactMode<D> &mode,
                                        const Eigen::Array<double, D, 1> &value,
                                        const Eigen::Array<double, D, 1> &slope) {
  Eigen::Array<double, D, 1> curvature = -mode.kappa * slope - mode.lambda * value;
  if (mode.any_resonant) curvature += mode.resonant * value(mode.lanes() - 2);
  return curvature;
}

// Time derivative of a reading where the lanes have this slope and curvature.
template <int D>
double rate_of(const Reading<D> &reading, const Eigen::Array<double, D, 1> &slope,
               const Eigen::Array<double, D, 1> &curvature) {
  return (reading.on_value * slope).sum() + (reading.on_slope * curvature).sum();
}

// Expresses displacements and velocities in the lanes of `mode`; the stop states are left to the
// caller.
template <int D, class Masses>
void set_lanes(State<D> &state, const Scene &scene, const ContactMode<D> &mode,
               const Masses &masses) {
  state.mode = &mode;
  state.value.setZero(mode.lanes());
  state.slope.setZero(mode.lanes());
  set_forcing(state, scene);
  // The forcing lanes are set, the others zero: shape y is the steady response.
  const Eigen::Matrix<double, ContactMode<D>::masses, 1> x = masses.displacement -
                                                             mode.equilibrium -
                                                             mode.shape * state.value.matrix(),
                                                         v = masses.velocity -
                                                             mode.shape * state.slope.matrix();
  state.value += (mode.to_modal * x + mode.velocity_to_modal * v).array();
  state.slope += (mode.to_modal * v).array();
  tie_decays(state);
}

}  // namespace vibro_impact
