// Corrections of gaps, and of their speeds, that are known more accurately than the coordinates
// give them.
#pragma once

#include <cstddef>
#include <vector>

#include "motion.hpp"

namespace vibro_impact::detail {

// Applies the impulse on a mass at its stop that gives it this gap speed.
void hit(const Contact &contact, double speed, Motion &motion);

// Corrects the rounding of a gap and of its speed. The chain is displaced as by a force at the mass
// and moves likewise, which no stiff link or damper feels.
void place(const Contact &contact, const Gap &gap, Motion &motion);

// The rounding of several gaps, and of their speeds, corrected together, the smallest gap first. Of
// two masses on a stiff link the second moves along with the first: their distance, which the
// tension gives, is more accurate than either gap. The storage is reused.
class Placement {
 public:
  void clear();
  void add(const Contact &contact, const Gap &gap);
  void apply(Motion &motion);

 private:
  struct Part {
    const Contact *contact = nullptr;
    Gap gap = {};
    PerCoordinate displacement = {};  // this widens the gap by 1 and keeps those before it
    SpeedChange drift = {};           // likewise its speed
    bool moves_along = false;         // with the masses before it
  };
  std::vector<Part> parts_;
  std::size_t size_ = 0;  // of those in use

  static void keep(const Part &before, Part &part);
};

}  // namespace vibro_impact::detail
