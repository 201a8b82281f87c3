// The equations of a border orbit (border_curve.cpp): a period with the chatter cut short.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "curve_kinds.hpp"

namespace vibro_impact {

// An impact of a chatter at which its speed and the next are compared.
struct Compared {
  std::size_t impact = 0;
  bool similar = false;  // the speeds before it fall as on a border orbit, too
  double next = 0.0;     // the excess with which the impact after it is the last near the border
};

// What is zero on a border orbit, and its derivatives by the free coordinates of the section and by
// the two parameters, in this order.
struct BorderEquations {
  Eigen::VectorXd residual;  // P(z) - z
  Eigen::MatrixXd residual_by;
  double excess = 0.0;
  Eigen::RowVectorXd excess_by;
  double end = 0.0;  // of the chatter, after the section
  Compared compared;
  EventSequence events;  // of the orbit but for the chatter
};

// At a place of the plane, from a section; `time`: of the end of the chatter, after it. `least`:
// the impact of the chatter to compare speeds at, where it is not yet far from the border. Nothing
// where there is no such chatter, or the orbit comes back in another contact mode. Throws what a
// run does.
std::optional<BorderEquations> border_equations(const BifurcationCurve &curve, const PlanePoint &at,
                                                const MotionState &section, double time,
                                                std::size_t least = 0);

}  // namespace vibro_impact
