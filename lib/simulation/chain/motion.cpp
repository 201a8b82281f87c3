#include "motion.hpp"

#include <algorithm>
#include <cmath>

#include "forces.hpp"
#include "tolerances.hpp"

namespace vibro_impact::detail {

using Complex = std::complex<double>;
using Eigen::Index;

void set_clock(Motion &motion, const Clock &clock, const Instant &instant) {
  const double angle = clock.omega * instant.phase;
  motion.now = instant;
  motion.turn = {std::cos(angle), std::sin(angle)};
}

void pass_time(Motion &motion, const Clock &clock, double tau) {
  const double step = tau + motion.now_low, phase = motion.now.phase, sum = phase + step;
  const double added = sum - phase;
  motion.now_low = (phase - (sum - added)) + (step - added);  // rounding of the sum
  Instant now = later(motion.now, step, clock);
  if (now.cycle != motion.now.cycle && now.phase + motion.now_low >= 0.0) {
    // The phase of a new period is finer than that of the sum.
    const double finer = now.phase + motion.now_low;
    motion.now_low -= finer - now.phase;
    now.phase = finer;
  }
  set_clock(motion, clock, now);
}

double time_until(const Motion &motion, const Instant &instant, const Clock &clock) {
  return elapsed(motion.now, instant, clock) - motion.now_low;
}

void tie_decays(Motion &motion) {
  const ModalCoordinates &all = motion.mode->coordinates;
  for (Index j = 0; all.any_decay && j < motion.y.size(); ++j) {
    if (!all.decay[static_cast<std::size_t>(j)]) continue;
    // The drives of the two decays of a mode cancel in a gap speed, and their sum has no rounding.
    const double drive =
        all.drive_re(j) * motion.turn.real() - all.drive_im(j) * motion.turn.imag() + all.pull(j);
    const Twofold<double> decay = exact_product(-all.kappa(j), motion.y(j)),
                          sum = exact_sum(drive, decay.value),
                          tied = exact_sum(sum.value,
                                           sum.low + decay.low - all.kappa(j) * motion.y_low(j));
    motion.dy(j) = tied.value;
    motion.dy_low(j) = tied.low;
  }
}

void complete_change(Motion &motion) {
  tie_decays(motion);
  if (motion.any_following) std::fill(motion.following.begin(), motion.following.end(), false);
  motion.any_following = false;
}

double rate_in_motion(const Motion &motion) {
  const ContactMode &mode = *motion.mode;
  const ModalCoordinates &all = mode.coordinates;
  if (mode.falls) return 0.0;
  for (const Index j : mode.by_rate) {
    if (all.rate(j) <= mode.forcing_rate) break;
    const bool moves = motion.y(j) != 0.0 || motion.dy(j) != 0.0 || all.force(j) > 0.0;
    if (moves && !motion.following[static_cast<std::size_t>(j)]) return all.rate(j);
  }
  return mode.forcing_rate;
}

double unit_of_time(const ContactMode &mode, const StopState &stop) {
  return mode.falls ? stop.duration : std::min(1.0 / mode.fastest, stop.duration);
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
  return evaluate(contact, motion) > resolved_ratio * terms_of(contact, motion);
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
    const Gap gap = gap_of(contact, stops[contact.stop], motion);
    // With the gap first, std::max keeps a gap that is no number, for which the run is given up.
    state.displacement[contact.mass] =
        scene.stops[contact.stop].position - contact.sigma * std::max(gap.value, 0.0);
    state.velocity[contact.mass] = -contact.sigma * gap.speed;
  }
}

double pressing_force(const Scene &scene, const Contact &contact, const Motion &motion,
                      double gap_speed) {
  if (contact.held) return evaluate(contact, motion);
  const std::size_t i = contact.mass;
  Pair sums{};
  for (Index j = 0; j < motion.y.size(); j += 2)
    sums += pair(contact.row.data() + j) * acceleration(motion, j);
  const double right = i + 1 < scene.mass.size() ? scene.stiffness[i + 1] : 0.0,
               drag = scene.beta * (scene.stiffness[i] + right + entry_of(scene.ground, i));
  return -scene.mass[i] * sum(sums) - drag * gap_speed;
}

}  // namespace vibro_impact::detail
