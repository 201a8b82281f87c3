#include "impact.hpp"

#include <cmath>

#include "simulation/chain/pair.hpp"
#include "simulation/chain/tolerances.hpp"

namespace vibro_impact::detail {

void leave_stop(const Contact &contact, double speed, Motion &motion,
                std::vector<StopState> &stops) {
  hit(contact, speed, motion);
  stops[contact.stop].contact = {.speed = speed};
}

bool is_negligible(const Contact &contact, double speed, const Motion &motion) {
  return speed < negligible * dot_moduli(contact.modulus, motion.dy);
}

bool is_as_at_rest(const Gap &gap, double reach, double rate) {
  const double rounding = negligible * negligible * reach;
  return gap.value <= rounding && std::abs(gap.speed) <= rounding * rate;
}

double next_flight(const Scene &scene, const Contact &contact, double speed, const Motion &motion) {
  const double press = pressing_force(scene, contact, motion, speed);
  return press > 0.0 ? 2.0 * speed * scene.mass[contact.mass] / press : infinity;
}

}  // namespace vibro_impact::detail
