// An impact in the modal coordinates: Eqs. 8-11 as Psi^-1 R Psi (Eq. 16), which is (10) of
// lib/README.md.
#pragma once

#include <vector>

#include "simulation/chain/placement.hpp"

namespace vibro_impact::detail {

// Sets the gap of the contact to exactly 0 and its gap speed to `speed`, in the coordinates and in
// the state of the stop.
void leave_stop(const Contact &contact, double speed, Motion &motion,
                std::vector<StopState> &stops);

// True when a speed at this contact lies below the rounding of the speeds of the chain.
bool is_negligible(const Contact &contact, double speed, const Motion &motion);

// True of a mass in flight whose gap and gap speed are so small that twice the precision does not
// resolve them beside a motion that reaches this far within 1 / rate.
bool is_as_at_rest(const Gap &gap, double reach, double rate);

// The time 2 m v / F to the next impact, to leading order, of a mass that has just left its stop
// with this speed v. F is the force that presses the mass towards the stop; without one the time is
// infinite.
double next_flight(const Scene &scene, const Contact &contact, double speed, const Motion &motion);

}  // namespace vibro_impact::detail
