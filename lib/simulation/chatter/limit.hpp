// The motion at the limit of a complete chatter. It is the flight from the latest impact without
// further impacts, plus the responses to the impacts to come. The responses depend on these impacts
// through the moments M_n only: (12) of lib/README.md.
#pragma once

#include <vector>

#include "chatter_table.hpp"
#include "simulation/flight/first_event.hpp"

namespace vibro_impact::detail {

// The motion at a limit, with storage that is reused.
struct LimitState {
  Motion motion;
  std::vector<StopState> stops;
  // Estimated error of the responses, relative to the jump of the oldest impact used.
  double error = 0.0;
  TaylorTable flight_table, response_table;
  PerCoordinate added, added_slope;  // the responses in y and y'
  PerCoordinate jumps, speed;        // bounds of the impacts to come, and of |y'|
};

// True when no contact outside the chatter can come to zero up to the limit. A mass that rests
// without force is tied to nothing that moves. The jumps of the gap
// speed at the impacts to come add up to at most `jump_sum_factor` times J r / (1 - r), with J the
// latest jump.
bool others_stay_out_of_reach(const Chatter &chatter, const Motion &motion,
                              const std::vector<StopState> &stops, double omega, double time_left,
                              LimitState &state);

// Sets the state at the limit from the motion just after the latest impact, with the masses hit at
// rest on their stops. The error is the difference that the oldest node makes to the moments M_n,
// weighted by (rate length)^n / n! as in the response of the fastest coordinate. The error of the
// time of the limit does not bound this one: the mass itself may hardly respond to that coordinate.
void set_limit_state(const Chatter &chatter, const ChatterLimit &limit, const Step &step,
                     const Clock &clock, bool forced, const Motion &motion,
                     const std::vector<StopState> &stops, LimitState &state);

}  // namespace vibro_impact::detail
