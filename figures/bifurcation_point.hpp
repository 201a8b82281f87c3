// A bifurcation point found in two ways.
#pragma once

#include <string>

#include "vibro_impact/analysis/locate.hpp"

namespace vibro_impact::figures {

struct BifurcationPoint {
  std::string symbol;
  Located omega;
  std::string method;
  double check = 0.0;  // the same by bisection on a count of events
  std::string checked_by;
};

// Forcing periods left out before the motion from rest counts as settled, and those then counted
// over: sticking motions of period 1, 2 and 4 give the same count in every window.
constexpr int settling = 150, counted = 4;

}  // namespace vibro_impact::figures
