#include "impact.hpp"

#include <limits>

#include "simulation/chain/pair.hpp"
#include "simulation/chain/tolerances.hpp"

namespace vibro_impact::detail {

void place(const Contact &contact, const InFlight &flight, Motion &motion) {
  const double jump = flight.speed - gap_speed(contact, motion);
  motion.y += (flight.gap - evaluate(contact, motion)) * contact.placement;
  motion.dy += jump * contact.impulse;
  if (contact.impulse_value.size() > 0) motion.y += jump * contact.impulse_value;
  complete_change(motion);
}

void leave_stop(const Contact &contact, double speed, Motion &motion,
                std::vector<StopState> &stops) {
  place(contact, {0.0, speed}, motion);
  stops[contact.stop].contact = InFlight{0.0, speed};
  for (const Contact &other : motion.mode->contacts)
    if (other.mass == contact.mass && other.stop != contact.stop)
      if (auto *flight = std::get_if<InFlight>(&stops[other.stop].contact)) flight->speed = -speed;
}

bool is_negligible(const Contact &contact, double speed, const Motion &motion) {
  return speed < negligible * dot_moduli(contact.modulus, motion.dy);
}

double next_flight(const Scene &scene, const Contact &contact, double speed, const Motion &motion) {
  const double press = pressing_force(scene, contact, motion);
  return press > 0.0 ? 2.0 * speed * scene.mass[contact.mass] / press
                     : std::numeric_limits<double>::infinity();
}

}  // namespace vibro_impact::detail
