#include "quiet_flight.hpp"

#include <algorithm>
#include <cmath>

#include "simulation/chain/tolerances.hpp"

namespace vibro_impact::detail {

namespace {

using Eigen::Index;
// The time in which a distance closes at `speed` and a constant acceleration `push` towards zero,
// both of any sign. Infinite if it does not close.
double closing_time(double distance, double speed, double push) {
  const double square = speed * speed + 2.0 * push * distance;
  if (!(square >= 0.0)) return infinity;
  const double denominator = speed + std::sqrt(square);
  return denominator > 0.0 ? 2.0 * distance / denominator : infinity;
}

bool cancels_digits(const Motion &motion, Index j, double omega) {
  const ModalCoordinates &all = motion.mode->coordinates;
  if (!(all.steady(j) > 0.0 && omega > 0.0)) return false;
  const double lambda = all.lambda(j), square = omega * omega;
  if (!(std::hypot(lambda - square, all.kappa(j) * omega) < near_resonance * (lambda + square)))
    return false;
  const double moved =
      std::hypot(motion.y(j) - all.static_value(j), motion.dy(j) / all.frequency(j));
  return all.steady(j) > largest_response * moved;
}

}  // namespace

double quiet_time(const Motion &motion, const std::vector<StopState> &stops, double omega) {
  const ContactMode &mode = *motion.mode;
  const ModalCoordinates &all = mode.coordinates;
  const auto size = static_cast<Index>(all.size);
  for (Index j = 0; j < size; ++j)
    if (cancels_digits(motion, j, omega)) return 0.0;
  double quiet = infinity;
  for (const Contact &contact : mode.contacts) {
    if (!contact.held && rests_without_force(stops[contact.stop])) continue;
    double swing = 0.0, mean = contact.offset + contact.static_value, speed = 0.0, push = 0.0;
    for (Index j = 0; j < size; ++j) {
      const OscillatorState deviation = deviation_of(motion, j, omega);
      if (j == mode.drift && !contact.held) {
        mean += contact.row(j) * deviation.value;
        speed = -contact.row(j) * deviation.slope;
        push = -contact.row(j) * (all.constant(j) + (omega > 0.0 ? 0.0 : all.force_re(j)));
        continue;
      }
      const double amplitude = all.frequency(j) > 0.0
                                   ? std::hypot(deviation.value, deviation.slope / all.frequency(j))
                                   : std::abs(deviation.value);
      swing += contact.modulus(j) * (1.0 + contact.damping * all.rate(j)) * amplitude;
    }
    if (omega == 0.0)
      mean += contact.steady.real();
    else
      swing += std::abs(contact.steady);
    const double room = mean - swing - 2.0 * resolved_ratio * (std::abs(mean) + swing);
    if (!(room > 0.0)) return 0.0;
    quiet = std::min(quiet, closing_time(room, speed, push));
  }
  return quiet;
}

}  // namespace vibro_impact::detail
