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
  bool out_of_reach = false;  // (3) stays positive over the step: no polynomial is made
  Polynomial polynomial;
  std::optional<Root> root;  // the first root, if the step ends there
};

// One step of a flight. Its storage is reused, so that steps allocate no memory.
struct Flight {
  Step step;
  TaylorTable table, moduli;
  PerCoordinate travel, rate_travel;  // bounds of |y(t + tau) - y(t)| and of the same of y'
  std::vector<Approach> approaches;   // one for each contact of the mode
  double u = 1.0;                     // of the first event, or 1 at the end of the step
  bool event = false;                 // an event ends the step
  bool any_near = false;              // some contact was within reach
};

// A time during which no contact can come to zero. The amplitudes of the coordinates about their
// steady responses never grow and bound (3) for all times; the rigid-body mode drifts at a bounded
// speed. The time is infinite when no event can follow.
double quiet_time(const Motion &motion, const std::vector<StopState> &stops, double omega);

// Finds the first event at u in (0, 1] of flight.step, which begins at `motion`.
void find_first_event(const Motion &motion, const std::vector<StopState> &stops, const Clock &clock,
                      bool forced, Flight &flight, Counters &counters);

// Moves motion and stops to u of the step. At flight.u the gaps of impacts are exactly 0.
void move_along(const Flight &flight, double u, const Clock &clock, Motion &motion,
                std::vector<StopState> &stops);

// Moves motion and stops to `target`, in closed form. `change` is scratch.
void fly_along(const Instant &target, const Clock &clock, Motion &motion,
               std::vector<StopState> &stops, PerCoordinate &change);

}  // namespace vibro_impact::detail
