// A bifurcation point found in two ways, and the table of them.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "vibro_impact/analysis/locate.hpp"
#include "vibro_impact/analysis/periodic_orbit.hpp"
#include "vibro_impact/table.hpp"

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

// What `read` makes of the motion at every frequency of a branch, in the order given: it starts
// from the motion at the one before and settles for `periods` periods. `read(scene, state)` may
// carry the state on by whole periods.
template <class SceneAt, class Read>
auto along_branch(const std::vector<double> &omegas, const SceneAt &scene_at, int periods,
                  const Read &read) {
  MotionState state = settled(scene_at(omegas.front()), settling);
  std::vector<decltype(read(Scene{}, state))> values;
  for (const double omega : omegas) {
    const Scene scene = scene_at(omega);
    state = stroboscopic_map(scene, state, periods).state;
    values.push_back(read(scene, state));
  }
  return values;
}

// Columns of the table of points. All numbers in it are computed; the error is the largest of the
// estimate of the method, the distance between the two methods, and what rounding over one period
// does to either.
inline Table bifurcation_table(const std::vector<BifurcationPoint> &points) {
  Table table("symbol,value,kind,error,method,check,checked_by");
  for (const BifurcationPoint &point : points)
    table.row(point.symbol, point.omega.value, "computed",
              std::max({point.omega.error, std::abs(point.omega.value - point.check), 2e-15}),
              point.method, point.check, point.checked_by);
  return table;
}

}  // namespace vibro_impact::figures
