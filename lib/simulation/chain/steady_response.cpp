#include "steady_response.hpp"

#include <algorithm>
#include <cmath>

#include "tolerances.hpp"

namespace vibro_impact::detail {

namespace {

using Complex = std::complex<double>;
using Eigen::Index;

// The steady response of a coordinate without its constant part, and its slope.
OscillatorState steady_state(const ModalCoordinates &all, Index j, Complex turn, double omega) {
  if (!(all.steady(j) > 0.0) || std::isinf(all.steady(j))) return {0.0, 0.0};
  const Complex steady = all.steady_of(j) * turn;
  return {steady.real(), -omega * steady.imag()};
}

Coordinate coordinate_of(const Motion &motion, Index j) {
  return {{motion.y(j), motion.y_low(j)}, {motion.dy(j), motion.dy_low(j)}};
}

void set_coordinate(Motion &motion, Index j, const Coordinate &moved) {
  motion.y(j) = moved.y.value;
  motion.y_low(j) = moved.y.low;
  motion.dy(j) = moved.dy.value;
  motion.dy_low(j) = moved.dy.low;
}

void follow(Motion &motion, Index j, double omega) {
  const OscillatorState steady = steady_state(motion.mode->coordinates, j, motion.turn, omega);
  set_coordinate(motion, j,
                 {{motion.mode->coordinates.static_value(j) + steady.value}, {steady.slope}});
}

// The deviation of coordinate j at `place` from this steady response and its constant part.
OscillatorState deviation_from(const OscillatorState &steady, const ModalCoordinates &all, Index j,
                               const Coordinate &place) {
  return {(place.y.value - all.static_value(j) - steady.value) + place.y.low,
          (place.dy.value - steady.slope) + place.dy.low};
}

// The change of the deviation z of a coordinate from its steady response.
OscillatorState free_change(const ModalCoordinates &all, Index j, const OscillatorState &z,
                            double tau, double tau_low) {
  const double kappa = all.kappa(j), lambda = all.lambda(j);
  if (all.decay[static_cast<std::size_t>(j)]) return {z.value * std::expm1(-kappa * tau), 0.0};
  if (all.rate(j) * tau <= max_step_radians)
    return change_by_series(kappa, lambda, z, 0.0, lambda > 0.0 ? 0.0 : all.constant(j), 0.0, tau);
  const OscillatorState end =
      free_response(kappa, lambda, free_response(kappa, lambda, z, tau), tau_low);
  return {end.value - z.value, end.slope - z.slope};
}

// tau + low between the motion and an instant.
Twofold<double> duration_of(const Motion &motion, const Instant &target, const Clock &clock) {
  const double phases = target.phase - motion.now.phase, sum = elapsed(motion.now, target, clock),
               tau = sum - motion.now_low, rounded = (sum - tau) - motion.now_low;
  if (target.cycle == motion.now.cycle) return {tau, (phases - sum) + rounded};
  const double cycles = static_cast<double>(target.cycle) - static_cast<double>(motion.now.cycle);
  const Twofold<double> whole = exact_product(cycles, clock.period);
  return {tau, ((whole.value - sum) + phases) + (whole.low + cycles * clock.period_low) + rounded};
}

}  // namespace

OscillatorState deviation_of(const Motion &motion, Index j, double omega) {
  const ModalCoordinates &all = motion.mode->coordinates;
  return deviation_from(steady_state(all, j, motion.turn, omega), all, j, coordinate_of(motion, j));
}

void move_by_deviation(Motion &motion, Index j, const Coordinate &before, Complex turn,
                       double omega, double tau, double tau_low) {
  if (motion.following[static_cast<std::size_t>(j)]) return follow(motion, j, omega);
  const ModalCoordinates &all = motion.mode->coordinates;
  const OscillatorState from = steady_state(all, j, turn, omega),
                        to = steady_state(all, j, motion.turn, omega);
  const OscillatorState change =
      free_change(all, j, deviation_from(from, all, j, before), tau, tau_low);
  set_coordinate(motion, j,
                 {before.y + -from.value + to.value + change.value,
                  before.dy + -from.slope + to.slope + change.slope});
}

void let_dead_coordinates_follow(Motion &motion, double omega) {
  const ContactMode &mode = *motion.mode;
  const ModalCoordinates &all = mode.coordinates;
  if (!mode.damped) return;
  double acceleration = -1.0, extent = 0.0;  // of the whole motion, summed when it is needed
  for (const Index j : mode.by_rate) {
    char &follows = motion.following[static_cast<std::size_t>(j)];
    if (follows) continue;
    if (!(all.kappa(j) > 0.0 && all.rate(j) > least_ratio_to_follow * mode.forcing_rate)) return;
    if (acceleration < 0.0) {
      acceleration =
          dot_moduli(mode.acceleration_weight, motion.y) + dot_moduli(mode.speed_weight, motion.dy);
      extent = dot_moduli(mode.extent, motion.y);
    }
    const OscillatorState steady = steady_state(all, j, motion.turn, omega);
    const double rate = all.rate(j);
    const double speed =
        mode.extent(j) * (rate * std::abs(motion.y(j) - all.static_value(j) - steady.value) +
                          std::abs(motion.dy(j) - steady.slope));
    const double rounding =
        response_rounding * mode.extent(j) * (all.steady(j) + std::abs(all.static_value(j)));
    const bool dead = speed * rate <= std::max(negligible * acceleration, rounding * rate * rate) &&
                      speed / rate <= std::max(negligible * extent, rounding);
    if (!dead) return;  // no slower coordinate limits the steps
    follows = motion.any_following = true;
    follow(motion, j, omega);
  }
}

void fly(Motion &motion, const Clock &clock, const Instant &target) {
  const ModalCoordinates &all = motion.mode->coordinates;
  const auto [tau, tau_low] = duration_of(motion, target, clock);
  const Complex turn = motion.turn;
  set_clock(motion, clock, target);
  motion.now_low = 0.0;
  for (Index j = 0; j < static_cast<Index>(all.size); ++j) {
    const Coordinate before = coordinate_of(motion, j);
    const bool follows = motion.following[static_cast<std::size_t>(j)];
    const bool slow = all.rate(j) * tau <= max_step_radians;
    if (follows || !slow || clock.omega * tau > max_step_radians) {
      move_by_deviation(motion, j, before, turn, clock.omega, tau, tau_low);
      continue;
    }
    // Over a time that is short against the forcing and the mode, the steady response cancels
    // digits of the change.
    const OscillatorState change =
        change_by_series(all.kappa(j), all.lambda(j), {motion.y(j), motion.dy(j)},
                         all.force_of(j) * turn, all.constant(j), clock.omega, tau);
    set_coordinate(motion, j, {before.y + change.value, before.dy + change.slope});
  }
  tie_decays(motion);
}

}  // namespace vibro_impact::detail
