// How far the lanes can carry a gap or a hold force, without a polynomial of it. No lane moves
// faster than |y'| + rate |y|, for y'^2 + lambda y^2 never grows and lambda <= rate^2; one in
// resonance gains what the forcing does in the time.
#pragma once

#include "simulation/chain/motion.hpp"

namespace vibro_impact {

// Sets bounds of the speeds of the lanes for `time`.
template <int D>
void bound_speeds(const State<D> &state, double time, Eigen::Array<double, D, 1> &speeds) {
  const ContactMode<D> &mode = *state.mode;
  speeds = state.slope.abs() + mode.rate * state.value.abs();
  if (mode.any_resonant) speeds += time * mode.resonant.abs();
}

// Reads the gap of a contact off the lanes.
template <int D>
void read_gap(State<D> &state, const Contact<D> &contact) {
  set_in_flight(state.stops[contact.stop], std::max(0.0, watched_now(state, contact)),
                (contact.watched.on_value * state.slope).sum());
}

// Reads all gaps off the lanes, of a motion that is only shown.
template <int D>
void read_gaps(State<D> &state) {
  for (const Contact<D> &contact : state.mode->contacts)
    if (!contact.held && !stays_at_rest(state.stops[contact.stop])) read_gap(state, contact);
}

// True when what a contact watches, `now`, is certain to stay positive for `time`, by this share of
// its size, the lanes moving no faster than `speeds`. `jumps` is what impacts to come may take off
// it at once: a hold force jumps with the speeds of the neighbours.
template <int D>
bool stays_clear(const State<D> &state, const Contact<D> &contact, double now,
                 const Eigen::Array<double, D, 1> &speeds, double time, double margin,
                 double jumps = 0.0) {
  const ContactMode<D> &mode = *state.mode;
  double rate = (contact.reach * speeds).sum();
  if (mode.any_resonant) rate += (contact.watched.on_slope * mode.resonant).abs().sum();
  return now > jumps + (1.0 + wide) * time * rate + margin * size_of(state, contact);
}

// True when no contact can ever change: the amplitudes of the lanes, which never grow, bound what
// each of them watches for all time. Such a motion goes to its end in one step.
template <int D>
bool stays_clear_for_ever(const State<D> &state, const Scene &scene) {
  const ContactMode<D> &mode = *state.mode;
  const Eigen::Index modal = mode.modal_lanes(), c = modal, s = modal + 1;
  const auto amplitude = [&](Eigen::Index j) {
    const double y = state.value(j), v = state.slope(j), lambda = mode.lambda(j);
    const double largest = lambda > 0.0 ? std::sqrt(y * y + v * v / lambda) : std::abs(y);
    if (mode.resonant(j) == 0.0) return largest;
    const double detuning = lambda - scene.omega * scene.omega, loss = mode.kappa(j) * scene.omega;
    // The steady response, and as much once more in the deviation from it; infinite where it grows.
    return largest +
           2.1 * std::abs(mode.resonant(j)) / std::sqrt(detuning * detuning + loss * loss);
  };
  for (const Contact<D> &contact : mode.contacts) {
    const Reading<D> &watched = contact.watched;
    double swing = 0.0, rest = watched.offset;
    if (!contact.held && stays_at_rest(state.stops[contact.stop])) continue;  // no force acts
    for (Eigen::Index j = 0; j < modal; ++j) {
      if (mode.rate(j) == 0.0) {  // the rigid-body mode: where it is, or moving away
        if (mode.resonant(j) != 0.0 || watched.on_value(j) * state.slope(j) < 0.0) return false;
        rest += watched.on_value(j) * state.value(j);
        continue;
      }
      swing += (std::abs(watched.on_value(j)) + mode.rate(j) * std::abs(watched.on_slope(j))) *
               amplitude(j);
    }
    if (mode.lanes() > modal) {  // P cos + Q sin, or the constant P where Omega = 0
      const double on_cosine = watched.on_value(c) + scene.omega * watched.on_slope(s);
      const double on_sine = watched.on_value(s) - scene.omega * watched.on_slope(c);
      if (scene.omega == 0.0)
        rest += on_cosine;
      else
        swing += std::sqrt(on_cosine * on_cosine + on_sine * on_sine);
    }
    if (!(rest - swing > 2.0 * wide * (std::abs(rest) + swing))) return false;
  }
  return true;
}

}  // namespace vibro_impact
