#include "motion.hpp"

#include <algorithm>
#include <cmath>

#include "forces.hpp"
#include "tolerances.hpp"

namespace vibro_impact::detail {

namespace {

using Complex = std::complex<double>;
using Eigen::Index;

Complex turn_at(double omega, double phase) {
  return {std::cos(omega * phase), std::sin(omega * phase)};
}

// The turning part of the steady response of a coordinate, and its slope.
OscillatorState steady_state(const ModalCoordinates &all, Index j, Complex turn, double omega) {
  const Complex steady = all.steady_of(j) * turn;
  return {steady.real(), -omega * steady.imag()};
}

// Lets a coordinate follow its steady response.
void set_steady_state(Motion &motion, Index j, double omega) {
  const OscillatorState steady = steady_state(motion.mode->coordinates, j, motion.turn, omega);
  motion.y(j) = motion.mode->coordinates.rest(j) + steady.value;
  motion.dy(j) = steady.slope;
}

void tie_decays(Motion &motion) {
  const ModalCoordinates &all = motion.mode->coordinates;
  if (all.any_decay)
    for (Index j = 0; j < motion.y.size(); ++j)
      if (all.decay[static_cast<std::size_t>(j)])
        motion.dy(j) = all.drive_re(j) * motion.turn.real() - all.drive_im(j) * motion.turn.imag() +
                       all.pull(j) - all.kappa(j) * motion.y(j);
}

// The time tau + rest between two instants, where `rest` is the rounding of tau.
struct Duration {
  double tau, rest;
};

Duration duration_of(const Motion &motion, const Instant &target, const Clock &clock) {
  const double phases = target.phase - motion.now.phase, sum = elapsed(motion.now, target, clock),
               tau = sum - motion.now_rest, rounded = (sum - tau) - motion.now_rest;
  if (target.cycle == motion.now.cycle) return {tau, (phases - sum) + rounded};
  const double cycles = static_cast<double>(target.cycle) - static_cast<double>(motion.now.cycle),
               whole = cycles * clock.period,
               whole_rest = std::fma(cycles, clock.period, -whole) + cycles * clock.period_rest;
  return {tau, ((whole - sum) + phases) + whole_rest + rounded};
}

// The difference of the state of one coordinate after a time from `start`. `turn` is e^(i Omega t)
// at the start.
OscillatorState change_of(const ContactMode &mode, Index j, OscillatorState start, Complex turn,
                          Complex turn_after, double omega, Duration duration) {
  const ModalCoordinates &all = mode.coordinates;
  const double tau = duration.tau, kappa = all.kappa(j), lambda = all.lambda(j),
               constant = all.constant(j);
  const Complex force = all.force_of(j) * turn, force_after = all.force_of(j) * turn_after;
  if (j == mode.drift) {
    const OscillatorState forced = forced_drift(force, force_after, omega, tau);
    return {start.slope * tau + (forced.value + constant * tau * tau / 2),
            forced.slope + constant * tau};
  }
  const bool slow = all.rate(j) * tau <= max_step_radians;
  if (slow && (force == 0.0 || omega * tau <= max_step_radians))
    return change_by_series(kappa, lambda, start, force, constant, omega, tau);
  // Over a short time of a soft coordinate its static position would cancel digits.
  const bool decay = all.decay[static_cast<std::size_t>(j)];
  const double rest = slow ? 0.0 : all.rest(j);
  OscillatorState pushed{0.0, 0.0};
  if (decay)
    pushed.value = slow ? -all.rest(j) * std::expm1(-kappa * tau) : 0.0;
  else if (slow && constant != 0.0)
    pushed = change_by_series(kappa, lambda, {0.0, 0.0}, 0.0, constant, 0.0, tau);
  const auto free_motion = [&](const OscillatorState &from) {
    if (decay) return OscillatorState{from.value * std::exp(-kappa * tau), from.slope};
    return free_response(kappa, lambda, free_response(kappa, lambda, from, tau), duration.rest);
  };
  const double detuning = lambda - omega * omega;
  OscillatorState before{0.0, 0.0}, after = before;  // what the forcing adds at either end
  if (force != 0.0 && !decay &&
      std::hypot(detuning, kappa * omega) < near_resonance * (lambda + omega * omega)) {
    after = forced_from_rest(kappa, lambda, force, force_after, omega, tau);
  } else {
    before = steady_state(all, j, turn, omega);
    after = steady_state(all, j, turn_after, omega);
  }
  const OscillatorState own =
      free_motion({start.value - before.value - rest, start.slope - before.slope});
  return {own.value + after.value + rest + pushed.value - start.value,
          own.slope + after.slope + pushed.slope - start.slope};
}

}  // namespace

void set_clock(Motion &motion, const Clock &clock, const Instant &instant) {
  motion.now = instant;
  motion.turn = turn_at(clock.omega, instant.phase);
}

void pass_time(Motion &motion, const Clock &clock, double tau) {
  const double step = tau + motion.now_rest, phase = motion.now.phase, sum = phase + step;
  const double added = sum - phase;
  motion.now_rest = (phase - (sum - added)) + (step - added);  // rounding of the sum
  Instant now = later(motion.now, step, clock);
  if (now.cycle != motion.now.cycle && now.phase + motion.now_rest >= 0.0) {
    // The phase of a new period is finer than that of the sum.
    const double finer = now.phase + motion.now_rest;
    motion.now_rest -= finer - now.phase;
    now.phase = finer;
  }
  set_clock(motion, clock, now);
}

double time_until(const Motion &motion, const Instant &instant, const Clock &clock) {
  return elapsed(motion.now, instant, clock) - motion.now_rest;
}

void complete_move(Motion &motion, const Clock &clock) {
  const ContactMode &mode = *motion.mode;
  tie_decays(motion);
  for (std::size_t k = 0; k < motion.following.size(); ++k) {
    if (motion.following[k]) set_steady_state(motion, static_cast<Index>(k), clock.omega);
  }
  if (mode.slow.empty()) return;
  const Motion::Change &from = motion.change;
  const double tau = elapsed(from.instant, motion.now, clock) + (motion.now_rest - from.rest);
  for (std::size_t k = 0; k < mode.slow.size(); ++k) {
    const Index j = mode.slow[k];
    const OscillatorState &start = from.states[k];
    const OscillatorState change =
        change_of(mode, j, start, from.turn, motion.turn, clock.omega, {tau, 0.0});
    motion.y(j) = start.value + change.value;
    motion.dy(j) = start.slope + change.slope;
  }
}

void complete_change(Motion &motion) {
  tie_decays(motion);
  std::fill(motion.following.begin(), motion.following.end(), false);
  if (motion.mode->slow.empty()) return;
  Motion::Change &change = motion.change;
  change.instant = motion.now;
  change.rest = motion.now_rest;
  change.turn = motion.turn;
  change.states.clear();
  for (const Index j : motion.mode->slow) change.states.push_back({motion.y(j), motion.dy(j)});
}

void let_dead_coordinates_follow(Motion &motion, double omega) {
  const ContactMode &mode = *motion.mode;
  const ModalCoordinates &all = mode.coordinates;
  if (!mode.stiff) return;
  double acceleration = 0.0, extent = 0.0;
  for (Index j = 0; j < motion.y.size(); ++j) {
    const double rate = std::max(all.rate(j), all.force(j) > 0.0 ? omega : 0.0);
    acceleration += mode.extent(j) * rate * (rate * std::abs(motion.y(j)) + std::abs(motion.dy(j)));
    extent += mode.extent(j) * std::abs(motion.y(j));
  }
  for (Index j = 0; j < static_cast<Index>(all.size); ++j) {
    char &follows = motion.following[static_cast<std::size_t>(j)];
    if (follows || !(all.kappa(j) > 0.0)) continue;
    const OscillatorState steady = steady_state(all, j, motion.turn, omega);
    const double rate = all.rate(j);
    const double speed =
        mode.extent(j) * (rate * std::abs(motion.y(j) - all.rest(j) - steady.value) +
                          std::abs(motion.dy(j) - steady.slope));
    const double rounding =
        response_rounding * mode.extent(j) * (all.steady(j) + std::abs(all.rest(j)));
    if (speed * rate <= std::max(negligible * acceleration, rounding * rate * rate) &&
        speed / rate <= std::max(negligible * extent, rounding)) {
      follows = true;
      set_steady_state(motion, j, omega);
    }
  }
}

double rate_in_motion(const Motion &motion) {
  const ContactMode &mode = *motion.mode;
  const ModalCoordinates &all = mode.coordinates;
  if (mode.falls) return 0.0;
  if (!mode.stiff) return mode.fastest;
  double fastest = mode.forcing_rate;
  for (Index j = 0; j < static_cast<Index>(all.size); ++j) {
    const bool moves = motion.y(j) != 0.0 || motion.dy(j) != 0.0 || all.force(j) > 0.0;
    if (moves && !motion.following[static_cast<std::size_t>(j)])
      fastest = std::max(fastest, all.rate(j));
  }
  return fastest;
}

double unit_of_time(const ContactMode &mode, const StopState &stop) {
  return mode.falls ? stop.duration : std::min(1.0 / mode.fastest, stop.duration);
}

void fly(Motion &motion, const Clock &clock, const Instant &target, PerCoordinate &change) {
  const Duration duration = duration_of(motion, target, clock);
  const Complex after = turn_at(clock.omega, target.phase);
  change.setZero(motion.y.size());
  for (Index j = 0; j < static_cast<Index>(motion.mode->coordinates.size); ++j) {
    const OscillatorState step = change_of(*motion.mode, j, {motion.y(j), motion.dy(j)},
                                           motion.turn, after, clock.omega, duration);
    change(j) = step.value;
    motion.y(j) += step.value;
    motion.dy(j) += step.slope;
  }
  set_clock(motion, clock, target);
  motion.now_rest = 0.0;
  complete_move(motion, clock);
}

double displacement(const Motion &motion, std::size_t mass) {
  const auto i = static_cast<Index>(mass);
  const ContactMode &mode = *motion.mode;
  const double x = mode.equilibrium(i) + dot(mode.shape.data() + i * motion.y.size(), motion.y);
  return std::clamp(x, mode.lowest(i), mode.highest(i));
}

double velocity(const Motion &motion, std::size_t mass) {
  const auto i = static_cast<Index>(mass);
  return dot(motion.mode->shape.data() + i * motion.dy.size(), motion.dy);
}

double terms_of(const Contact &contact, const Motion &motion) {
  double sum = std::abs(contact.offset) + dot_moduli(contact.modulus, motion.y);
  if (contact.held)
    sum += contact.damping * dot_moduli(contact.modulus, motion.dy) + contact.forcing_modulus;
  return sum;
}

bool is_resolved(const Contact &contact, const Motion &motion) {
  return evaluate(contact, motion) > gap_reread_ratio * terms_of(contact, motion);
}

void set_state(const Motion &motion, const std::vector<StopState> &stops, const Scene &scene,
               MotionState &state) {
  const ContactMode &mode = *motion.mode;
  state.instant = motion.now;
  state.held = mode.held;
  state.displacement.resize(mode.held.size());
  state.velocity.resize(mode.held.size());
  for (std::size_t mass = 0; mass < mode.held.size(); ++mass) {
    state.displacement[mass] = displacement(motion, mass);
    state.velocity[mass] = velocity(motion, mass);
  }
  for (const Contact &contact : mode.contacts) {
    if (contact.held || is_resolved(contact, motion)) continue;
    const InFlight flight = flight_of(stops[contact.stop]);
    state.displacement[contact.mass] =
        scene.stops[contact.stop].position - contact.sigma * flight.gap;
    state.velocity[contact.mass] = -contact.sigma * flight.speed;
  }
}

double pressing_force(const Scene &scene, const Contact &contact, const Motion &motion) {
  if (contact.held) return evaluate(contact, motion);
  const double stop = scene.stops[contact.stop].position;
  return contact.sigma *
         force_on(
             scene, contact.mass,
             [&](std::size_t j) { return j == contact.mass ? stop : displacement(motion, j); },
             [&](std::size_t j) { return j == contact.mass ? 0.0 : velocity(motion, j); },
             forcing_at(motion.turn.real(), motion.turn.imag()));
}

}  // namespace vibro_impact::detail
