// Motions represented by their deviation from the steady response S, which has no rounding that
// adds up:
//   y(t + tau) = y(t) + S(t + tau) - S(t) + (the free motion of y - S in tau).
// Coordinates that follow S, slow coordinates and long flights move in this way. A scene whose
// rates are of the order of Omega, with stops within reach, does without.
#pragma once

#include "motion.hpp"
#include "oscillator.hpp"
#include "tolerances.hpp"

namespace vibro_impact::detail {

// True when some coordinate moves by its deviation over a step of this length. A slow coordinate is
// moved by sums over the steps otherwise, which would keep the rounding of its large response.
inline bool any_moves_by_deviation(const Motion &motion, double omega, double tau) {
  return motion.any_following || (motion.mode->any_slow && omega * tau > slow_rate);
}
inline bool moves_by_deviation(const Motion &motion, Eigen::Index j, double omega, double tau) {
  return motion.following[static_cast<std::size_t>(j)] ||
         (motion.mode->coordinates.slow[static_cast<std::size_t>(j)] && omega * tau > slow_rate);
}

// The deviation of a coordinate from its steady response. The rigid-body mode has no steady
// response to a constant force.
OscillatorState deviation_of(const Motion &motion, Eigen::Index j, double omega);

// One coordinate and its velocity.
struct Coordinate {
  Twofold<double> y, dy;
};

// Moves coordinate j by its deviation from the steady response, over tau + tau_low, to the clock of
// the motion. It stood at `before`, with the forcing at `turn`.
void move_by_deviation(Motion &motion, Eigen::Index j, const Coordinate &before,
                       std::complex<double> turn, double omega, double tau, double tau_low);

// Lets damped coordinates, the fastest first, follow their steady response once the deviation d =
// y - S has died out: in displacement and acceleration, d lies below the rounding of the whole
// motion or of S. The steps are then as long as the other coordinates allow.
void let_dead_coordinates_follow(Motion &motion, double omega);

// Moves to `target` in closed form.
void fly(Motion &motion, const Clock &clock, const Instant &target);

}  // namespace vibro_impact::detail
