// An impact in the modal coordinates: Eqs. 8-11 as Psi^-1 R Psi (Eq. 16), which is (10) of
// lib/README.md.
#pragma once

#include <vector>

#include "simulation/chain/motion.hpp"

namespace vibro_impact::detail {

// Brings the coordinates into agreement with a gap and a gap speed that are known better.
void place(const Contact &contact, const InFlight &flight, Motion &motion);

// Leaves the mass at its stop with this gap speed, which is kept to full relative accuracy beside
// the coordinates. A stop across sees the same jump.
void leave_stop(const Contact &contact, double speed, Motion &motion,
                std::vector<StopState> &stops);

// The gap speed of a mass in flight; 0 at rest.
double speed_of(const StopState &stop);

// True when a speed at this contact is lost in the rounding of those the chain moves at.
bool is_negligible(const Contact &contact, double speed, const Motion &motion);

// Time to the next impact at a stop that the mass has just left with this speed, to leading order,
// where a constant force presses it; infinite where none does.
double next_flight(const Scene &scene, const Contact &contact, double speed, const Motion &motion);

}  // namespace vibro_impact::detail
