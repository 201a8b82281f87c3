// What the axes of a plot tell of the data in it.
//
// The paper's plots are autoscaled: an axis ends at the first tick beyond the data. Data that reach
// a stop exceed it by the tolerance of the paper's simulation: an axis ends at 0.12 above a stop at
// 0.1, at 0.35 and at 0.31 above one at 0.3, ticks 0.02, 0.05 and 0.01 apart. So each end of a
// printed axis says between which two ticks the extreme of the data lies.
#pragma once

#include <algorithm>
#include <limits>

#include "reference/scenes/paper_scenes.hpp"

namespace vibro_impact::figures {

struct Range {
  double lowest = std::numeric_limits<double>::infinity();
  double highest = -std::numeric_limits<double>::infinity();

  void include(double value) {
    lowest = std::min(lowest, value);
    highest = std::max(highest, value);
  }
};

// How far inside its axis each extreme of the data lies, in ticks: the rule wants 0 to 1.
struct TicksInside {
  double at_lowest, at_highest;
};

inline TicksInside ticks_inside(const Range &data, const Range &axis, double tick) {
  return {(data.lowest - axis.lowest) / tick, (axis.highest - data.highest) / tick};
}

// The rule. An extreme on a tick counts for either side of it (see above), to within the rounding
// of the data.
inline bool fills(const Range &data, const Range &axis, double tick) {
  constexpr double rounding = 1e-9;  // in ticks
  const auto within = [](double ticks) { return ticks >= -rounding && ticks <= 1.0 + rounding; };
  const TicksInside inside = ticks_inside(data, axis, tick);
  return within(inside.at_lowest) && within(inside.at_highest);
}

// The ordinate and the abscissa of a panel.
inline Range ordinate(const paper::AxisBox &box) {
  return {box.lowest, box.highest};
}
inline Range abscissa(const paper::AxisBox &box) {
  return {box.from, box.to};
}

}  // namespace vibro_impact::figures
