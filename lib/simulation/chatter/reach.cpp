#include "reach.hpp"

#include <algorithm>
#include <cmath>

namespace vibro_impact::detail {

namespace {

// Bounds of |x'| and |x''| up to the limit: of a mass, and of all of them.
struct MotionBounds {
  const Motion &motion;
  const Chatter &chatter;
  double left, acceleration;

  // A bound of the sum of the jumps of its velocity.
  double jump(std::size_t i) const {
    return i == chatter.contact().mass ? jump_sum_factor * std::abs(chatter.latest_jump()) : 0.0;
  }
  double speed(std::size_t i) const {
    return std::abs(motion.v[i].hi) + jump(i);
  }
};

// The accelerations change by little until the limit: in half a radian the fastest mode adds at
// most its rate times its speed. The factor of two is a margin.
MotionBounds bounds_of(const Chain &chain, const Motion &motion, const Chatter &chatter,
                       double left) {
  MotionBounds bounds{motion, chatter, left, 0.0};
  double speed = 0.0, second = 0.0, force = 0.0;
  for (std::size_t i = 0; i < chain.masses; ++i) {
    if (motion.mode->held[i] != 0) continue;
    speed = std::max(speed, bounds.speed(i));
    second = std::max(second, std::abs(motion.acceleration[i]));
    force = std::max(force, (std::abs(chain.a[i]) + std::abs(chain.b[i])) / chain.mass[i]);
  }
  const double rate = motion.mode->fastest;
  bounds.acceleration =
      2.0 * (second + (rate + left * rate * rate) * speed + left * chain.omega * force);
  return bounds;
}

// A bound of the fall of a contact up to the limit.
double fall_of(const Chain &chain, const Contact &contact, const MotionBounds &bounds) {
  const std::size_t i = contact.mass;
  const double left = bounds.left;
  if (!contact.held) return left * (bounds.speed(i) + left * bounds.acceleration);
  double rate = chain.omega * std::hypot(chain.a[i], chain.b[i]), jump = 0.0;
  chain.each_link(i, [&](double stiffness, std::size_t other) {
    rate += stiffness * (bounds.speed(other) + (left + chain.beta) * bounds.acceleration);
    jump += stiffness * chain.beta * bounds.jump(other);
  });
  return jump + left * rate;
}

}  // namespace

bool others_stay_out_of_reach(const Chain &chain, const Chatter &chatter, const Motion &motion,
                              const std::vector<StopState> &stops, double left) {
  const ContactMode &mode = *motion.mode;
  if (!(left * mode.fastest < longest_rest_of_chatter)) return false;
  const MotionBounds bounds = bounds_of(chain, motion, chatter, left);
  return std::all_of(mode.contacts.begin(), mode.contacts.end(), [&](const Contact &contact) {
    if (contact.stop == chatter.contact().stop || is<Forceless>(stops[contact.stop].at))
      return true;
    const Value value = evaluate(chain, contact, motion);
    return rounded(value.value) > travel_margin * fall_of(chain, contact, bounds);
  });
}

}  // namespace vibro_impact::detail
