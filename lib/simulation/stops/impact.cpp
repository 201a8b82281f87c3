#include "impact.hpp"

#include <cmath>
#include <limits>

#include "simulation/chain/pair.hpp"
#include "simulation/chain/tolerances.hpp"

namespace vibro_impact::detail {

namespace {

// Adds factor a_j to y_j + low_j.
void add(double factor, const PerCoordinate &a, PerCoordinate &y, PerCoordinate &low) {
  for (Eigen::Index j = 0; j < y.size(); j += 2) {
    const Twofold<Pair> before{pair(y.data() + j), pair(low.data() + j)},
        after = before + factor * pair(a.data() + j);
    store(after.value, y.data() + j);
    store(after.low, low.data() + j);
  }
}

}  // namespace

void place(const Contact &contact, const Gap &gap, Motion &motion) {
  const auto add_jump = [&](double jump) {
    add(jump, contact.impulse, motion.dy, motion.dy_low);
    if (contact.impulse_value.size() > 0) add(jump, contact.impulse_value, motion.y, motion.y_low);
  };
  const Gap before = gap_at(contact, motion);
  const double jump = gap.speed - before.speed;
  add(gap.value - before.value, contact.placement, motion.y, motion.y_low);
  add_jump(jump);
  complete_change(motion);
  // The jump is rounded. A speed far below the jump gets its digits from a second one.
  if (!(std::abs(gap.speed) < resolved_ratio * std::abs(jump))) return;
  const Gap left = gap_at(contact, motion);
  add(gap.value - left.value, contact.placement, motion.y, motion.y_low);
  add_jump(gap.speed - left.speed);
  complete_change(motion);
}

void leave_stop(const Contact &contact, double speed, Motion &motion,
                std::vector<StopState> &stops) {
  place(contact, {0.0, speed}, motion);
  stops[contact.stop].contact = InFlight{speed};
}

bool is_negligible(const Contact &contact, double speed, const Motion &motion) {
  return speed < negligible * dot_moduli(contact.modulus, motion.dy);
}

double next_flight(const Scene &scene, const Contact &contact, double speed, const Motion &motion) {
  const double press = pressing_force(scene, contact, motion, speed);
  return press > 0.0 ? 2.0 * speed * scene.mass[contact.mass] / press
                     : std::numeric_limits<double>::infinity();
}

}  // namespace vibro_impact::detail
