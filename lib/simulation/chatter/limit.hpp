// The motion at the limit of a complete chatter: the flight from the latest impact as if none
// followed, plus the responses to the impacts to come, which depend on them through their moments
// only ((12) of lib/README.md).
#pragma once

#include <vector>

#include "chatter_table.hpp"
#include "simulation/flight/first_event.hpp"

namespace vibro_impact::detail {

// True when no other contact comes into play up to the limit, whatever the impacts to come: none of
// them is faster than the latest was, and their jumps add up to less than `jump_sum_factor` times
// the first-order sum. `pushes` and `speed` are scratch.
bool others_stay_out_of_reach(const Chatter &chatter, const Motion &motion, double omega,
                              double time_left, PerCoordinate &pushes, PerCoordinate &speed);

// The motion at a limit, and its storage.
struct LimitState {
  Motion motion;
  std::vector<StopState> stops;
  double error =
      0.0;  // estimated, of the responses, relative to the jump of the oldest impact used
  TaylorTable flight, response;
  PerCoordinate added, added_slope;  // to y and y' by the responses
};

// Sets the state at the limit from the motion just after the latest impact, with the masses hit at
// rest on their stops. The error is what the oldest node changes in the moments, as the fastest
// coordinate feels it: where the mass itself hardly feels that one, the error of the time of the
// limit does not show it.
void set_limit_state(const Chatter &chatter, const ChatterLimit &limit, const Step &step,
                     const Clock &clock, bool forced, const Motion &motion,
                     const std::vector<StopState> &stops, LimitState &state);

}  // namespace vibro_impact::detail
