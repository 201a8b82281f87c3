// What the axes of a plot tell of the data in it.
//
// The paper's plots are autoscaled: an axis ends at the first tick beyond the data. Data that reach
// a stop exceed it by the tolerance of the paper's simulation: an axis ends at 0.12 above a stop at
// 0.1, at 0.35 and at 0.31 above one at 0.3, ticks 0.02, 0.05 and 0.01 apart. So each end of a
// printed axis says between which two ticks the extreme of the data lies.
#pragma once

#include <string>

#include "figures/panel.hpp"

namespace vibro_impact::figures {

// One axis of a panel: as printed, and the data it should fill.
struct AxisCheck {
  std::string panel, quantity;
  Range axis;
  double tick;
  Range data;

  // How far inside the axis each extreme of the data lies, in ticks.
  double ticks_at_lowest() const {
    return (data.lowest - axis.lowest) / tick;
  }
  double ticks_at_highest() const {
    return (axis.highest - data.highest) / tick;
  }
  // The rule: from 0 to 1. An extreme on a tick counts for either side of it (see above), to within
  // the rounding of the data.
  bool passes() const {
    constexpr double rounding = 1e-9;  // in ticks
    const auto within = [](double ticks) { return ticks >= -rounding && ticks <= 1.0 + rounding; };
    return within(ticks_at_lowest()) && within(ticks_at_highest());
  }
};

inline AxisCheck across(const std::string &panel, const paper::AxisBox &box, const Range &times) {
  return {panel, "t", {box.from, box.to}, box.tick_across, times};
}
inline AxisCheck upwards(const std::string &panel, const std::string &quantity,
                         const paper::AxisBox &box, const Range &data) {
  return {panel, quantity, {box.lowest, box.highest}, box.tick, data};
}

}  // namespace vibro_impact::figures
