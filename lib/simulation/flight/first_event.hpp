// The first event along one step: an impact, or a root of a hold force, or several of these at the
// same instant.
#pragma once

#include <optional>
#include <vector>

#include "simulation/chain/stop_state.hpp"
#include "taylor_table.hpp"

namespace vibro_impact::detail {

// (3) of one contact along the step: a gap or a hold force.
struct Approach {
  Polynomial polynomial;
  std::optional<Root> root;  // the first root, if the step ends there
};

// One step of a flight. Its storage is reused, so that steps allocate no memory.
struct Flight {
  Step step;
  TaylorTable table;
  PerCoordinate travel, rate_travel;  // bounds of |y(t + tau) - y(t)| and of the same of y'
  std::vector<Approach> approaches;   // one for each contact of the mode
  double u = 1.0;                     // of the first event, or 1 at the end of the step
  bool event = false;                 // an event ends the step
  bool any_near = false;              // some contact was within reach
  bool any_released = false;          // some mass was released at the start of the step
};

// Finds the first event at u in (0, 1] of flight.step, which begins at `motion`. u is NaN if the
// motion leaves the range of double precision.
void find_first_event(const Motion &motion, const std::vector<StopState> &stops, const Clock &clock,
                      bool forced, Flight &flight, Counters &counters);

// Moves motion and stops to u of the step. At flight.u the gaps of impacts are exactly 0.
void move_along(const Flight &flight, double u, const Clock &clock, Motion &motion,
                std::vector<StopState> &stops);

// Lets time pass at the stops: what was known at an instant is evaluated from then on.
void forget_instant(std::vector<StopState> &stops);

}  // namespace vibro_impact::detail
