// Where a run stands between events, in the lanes of its contact mode.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <vector>

#include "at_stop.hpp"
#include "contact_mode.hpp"
#include "oscillator.hpp"
#include "tolerances.hpp"
#include "vibro_impact/instant.hpp"

namespace vibro_impact {

template <int D>
struct State {
  using Lanes = Eigen::Array<double, D, 1>;
  Instant now;
  const ContactMode<D> *mode = nullptr;
  Lanes value, slope;
  std::vector<AtStop> stops;                                       // one per stop of the scene
  double span_expected = std::numeric_limits<double>::infinity();  // of the next flight
  bool clear = true;     // no stop was near in the latest flight
  Instant window_start;  // of the count of impacts in one forcing period
  long long impacts_in_window = 0;
};

// Sets the forcing lanes cos(Omega t), sin(Omega t) from the phase.
template <int D>
void set_forcing(State<D> &state, const Scene &scene) {
  if (state.mode->forcing_lanes == 0) return;
  const Eigen::Index c = state.mode->lanes() - 2, s = c + 1;
  const double angle = scene.omega * state.now.phase;
  state.value(c) = std::cos(angle);
  state.value(s) = std::sin(angle);
  state.slope(c) = -scene.omega * state.value(s);
  state.slope(s) = scene.omega * state.value(c);
}

// Lanes that are pure decays have y' = -kappa y.
template <int D>
void tie_decays(State<D> &state) {
  const ContactMode<D> &mode = *state.mode;
  if (mode.any_decay) state.slope = mode.decay.select(-mode.kappa * state.value, state.slope);
}

// Drops the damped lanes that have died out: those whose share in the acceleration lies far below
// the rounding of the whole, and in the displacement as well, where a slow lane remains when the
// fast ones are gone. A stiff scene then moves at the pace of what is still in motion.
template <int D>
void drop_dead_lanes(State<D> &state) {
  const ContactMode<D> &mode = *state.mode;
  if (!mode.stiff) return;
  const auto moving = mode.extent * (mode.rate * state.value.abs() + state.slope.abs());
  const double acceleration = (moving * mode.rate).sum(),
               displacement = (mode.extent * state.value.abs()).sum();
  for (Eigen::Index j = 0; j < mode.lanes(); ++j) {
    const double speed = moving(j), rate = mode.rate(j);
    if (speed * rate <= lost * acceleration && speed / rate <= lost * displacement &&
        mode.kappa(j) > 0.0 && mode.resonant(j) == 0.0)
      state.value(j) = state.slope(j) = 0.0;
  }
}

// Adds to lanes in resonance what the forcing, cos + i sin before and now, has done to them in tau.
template <int D>
void add_resonance(State<D> &state, const Scene &scene, std::complex<double> before, double tau) {
  const ContactMode<D> &mode = *state.mode;
  const Eigen::Index modal = mode.modal_lanes();
  const std::complex<double> now(state.value(modal), state.value(modal + 1));
  for (Eigen::Index j = 0; j < modal; ++j) {
    if (mode.resonant(j) == 0.0) continue;
    const double f = mode.resonant(j);
    const auto added =
        forced_from_rest(mode.kappa(j), mode.lambda(j), f * before, f * now, scene.omega, tau);
    state.value(j) += added.value;
    state.slope(j) += added.slope;
  }
}

// Moves lanes on by tau, in closed form, but for what the forcing does in resonance.
template <int D>
void flow(const ContactMode<D> &mode, Eigen::Array<double, D, 1> &value,
          Eigen::Array<double, D, 1> &slope, double tau) {
  for (Eigen::Index j = 0; j < mode.lanes(); ++j) {
    if (mode.decay(j)) {
      value(j) *= std::exp(-mode.kappa(j) * tau);
      slope(j) = -mode.kappa(j) * value(j);
      continue;
    }
    const auto after = free_response(mode.kappa(j), mode.lambda(j), {value(j), slope(j)}, tau);
    value(j) = after.value;
    slope(j) = after.slope;
  }
}

// What a contact watches, read off the lanes now. (A gap does not depend on their slopes.)
template <int D>
double watched_now(const State<D> &state, const Contact<D> &contact) {
  if (contact.held) return contact.watched(state.value, state.slope);
  return contact.watched.offset + (contact.watched.on_value * state.value).sum();
}

// The sum of the moduli of what that adds up: the scale of its rounding.
template <int D>
double size_of(const State<D> &state, const Contact<D> &contact) {
  double sum =
      std::abs(contact.watched.offset) + (contact.watched.on_value * state.value).abs().sum();
  if (contact.held) sum += (contact.watched.on_slope * state.slope).abs().sum();
  return sum;
}

// True when what a contact watches is wide: read off the lanes with few bits lost to cancellation.
// Narrower gaps are carried from event to event.
template <int D>
bool is_wide(const State<D> &state, const Contact<D> &contact) {
  return watched_now(state, contact) > wide * size_of(state, contact);
}

// One coordinate of every mass.
template <int D>
using Masses = Eigen::Matrix<double, ContactMode<D>::masses, 1>;

// Sets the motion of all masses in a state. A free mass in a narrow gap is placed by the carried
// one.
template <int D>
void set_motion(const State<D> &state, const Scene &scene, MotionState &motion) {
  const ContactMode<D> &mode = *state.mode;
  motion.instant = state.now;
  motion.held = mode.held;
  motion.displacement.resize(mode.held.size());
  motion.velocity.resize(mode.held.size());
  Eigen::Map<Masses<D>> x(motion.displacement.data(), mode.equilibrium.size()),
      v(motion.velocity.data(), mode.equilibrium.size());
  x = mode.equilibrium;
  x.noalias() += mode.shape * state.value.matrix();
  v.noalias() = mode.shape * state.slope.matrix();
  for (const Contact<D> &contact : mode.contacts) {
    if (contact.held || is_wide(state, contact)) continue;
    const AtStop &stop = state.stops[contact.stop];
    motion.displacement[contact.mass] =
        scene.stops[contact.stop].position - contact.sigma * stop.gap;
    motion.velocity[contact.mass] = -contact.sigma * stop.speed;
  }
}

// Sets how far these displacements, and velocities in units of `rate`, may be off by rounding: that
// of the largest of them, which all lanes have had a share in.
template <int D>
void set_rounding(const State<D> &state, const Scene &scene, double rate,
                  std::vector<double> &error) {
  const ContactMode<D> &mode = *state.mode;
  double largest = 0.0;
  for (Eigen::Index i = 0; i < mode.equilibrium.size(); ++i) {
    const auto moving = mode.shape.row(i).transpose().array().abs() *
                        (state.value.abs() + state.slope.abs() / rate);
    largest = std::max(largest, std::abs(mode.equilibrium(i)) + moving.sum());
  }
  error.assign(scene.mass.size(), rounding * largest);
  for (const Contact<D> &contact : mode.contacts)
    if (!contact.held && !is_wide(state, contact))
      error[contact.mass] = rounding * std::abs(scene.stops[contact.stop].position);
}

// Expresses a motion in the lanes of `mode`; the stops are left to the caller.
template <int D>
void set_lanes(State<D> &state, const Scene &scene, const ContactMode<D> &mode,
               const MotionState &motion) {
  state.mode = &mode;
  state.value.setZero(mode.lanes());
  state.slope.setZero(mode.lanes());
  set_forcing(state, scene);
  // The forcing lanes are set, the others zero: shape y is the steady response.
  const Eigen::Map<const Masses<D>> at(motion.displacement.data(), mode.equilibrium.size()),
      velocity(motion.velocity.data(), mode.equilibrium.size());
  const Masses<D> x = at - mode.equilibrium - mode.shape * state.value.matrix(),
                  v = velocity - mode.shape * state.slope.matrix();
  state.value += (mode.to_modal * x + mode.velocity_to_modal * v).array();
  state.slope += (mode.to_modal * v).array();
  tie_decays(state);
}

}  // namespace vibro_impact
