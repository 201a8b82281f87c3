// The motion at the limit of a complete chatter, extrapolated from the states that its nodes
// predict there: (12) of lib/README.md.
#pragma once

#include <vector>

#include "chatter_table.hpp"
#include "simulation/chain/placement.hpp"

namespace vibro_impact::detail {

// The motion at a limit, with storage that is reused.
struct LimitState {
  Motion motion;
  std::vector<StopState> stops;
  double error =
      0.0;  // estimated error of the speeds, relative to the jump of the oldest node used
  PerCoordinate difference, slope_difference;  // what the oldest node changes in y and y'
  PerCoordinate jumps, speed;                  // bounds of the impacts to come, and of |y'|
  Placement placed;                            // the gaps of the masses hit
};

// True when no contact outside the chatter can come to zero up to the limit. A mass that rests
// without force is tied to nothing that moves. The jumps of the gap speed at the impacts to come
// add up to at most `jump_sum_factor` times J r / (1 - r), with J the latest jump.
bool others_stay_out_of_reach(const Chatter &chatter, const Motion &motion,
                              const std::vector<StopState> &stops, double omega, double time_left,
                              LimitState &state);

// Sets the state at the limit from the motion just after the latest impact, which is a node, with
// the masses hit at rest on their stops. The error of the time of the limit does not bound that of
// the state: the mass itself may hardly respond to the fastest coordinate.
void set_limit_state(const Chatter &chatter, const ChatterLimit &limit, const Clock &clock,
                     const Motion &motion, const std::vector<StopState> &stops, LimitState &state);

}  // namespace vibro_impact::detail
