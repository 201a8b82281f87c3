// Whether a chatter may be carried to its limit: nothing else may happen before.
#pragma once

#include "chatter.hpp"
#include "simulation/chain/stop_state.hpp"

namespace vibro_impact::detail {

// True when no contact outside the chatter can come to zero within the time left. The latest node
// is at the motion, whose acceleration is known. The jumps at the impacts to come add up to at most
// `jump_sum_factor` times the geometric series.
bool others_stay_out_of_reach(const Chain &chain, const Chatter &chatter, const Motion &motion,
                              const std::vector<StopState> &stops, double left);

}  // namespace vibro_impact::detail
