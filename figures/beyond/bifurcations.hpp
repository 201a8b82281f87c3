// The bifurcation points of the Figure 2 scene for forcing frequencies from 0.25 to 0.5: where they
// are, found in two ways each.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "curves.hpp"
#include "figures/parallel.hpp"
#include "figures/grazing.hpp"

namespace vibro_impact::figures {

inline int sticks_from_rest(double omega, int mass) {
  return sticking_phases(paper::stops_of_different_sign(omega), mass, settling, counted);
}

// Every place in [below, above] where the count of a mass changes, by repeated bisection (to 2e-14:
// closer to a tangency the motion is decided by rounding, and takes long to decide); those
// closer together than 1e-11 are one, blurred by the settling.
inline std::vector<CountJump> changes_between(int mass, double below, double above) {
  const auto count = [mass](double omega) { return sticks_from_rest(omega, mass); };
  std::vector<CountJump> changes;
  const int at_end = count(above);
  while (count(below) != at_end) {
    const CountJump change = bisect(count, below, above, 2e-14);
    below = std::min(change.above + 1e-11, above);
    changes.push_back(change);
    changes.back().count_above = count(below);
  }
  return changes;
}

// The zero of the least pressing force, when the change is a multi-sliding bifurcation: on the side
// with fewer sticking phases the force on `mass` is about to touch zero inside one.
inline std::optional<Located> multi_sliding(const CountJump &change, int mass) {
  const double side = change.count_below < change.count_above ? -1.0 : 1.0;
  const double near = change.below + side * 1e-6;
  const Scene scene = paper::stops_of_different_sign(near);
  const MotionState seed = at_quiet_phase(scene, state_after_periods(scene, settling));
  const auto force = [&](double omega) {
    const Scene at = paper::stops_of_different_sign(omega);
    return least_pressing_force(at, orbit_near(at, seed, 1).value(),
                                at.stops[static_cast<std::size_t>(mass - 1)]);
  };
  const auto touching = force(near);
  if (!touching || touching->value > 1e-5) return std::nullopt;
  return zero_from_one_side([&](double omega) { return force(omega).value().value; },
                            change.below + side * 1e-4, change.below + side * 2e-5);
}

// The border orbit at the change: one of the chatters that complete on the side with more sticking
// phases does not on the other.
inline StartedCurve border_orbit(const CountJump &change, int mass) {
  const double side = change.count_below > change.count_above ? -1.0 : 1.0;
  return started({"omega_r",
                  fmt::format("border_mass_{}", mass),
                  Bifurcation::border_orbit,
                  mass,
                  {change.below, paper::figure2().restitution},
                  {side, 0.0}});
}

// The same border by bisection on the sticking phases of the orbit itself. Needed where another
// attractor lives beside the orbit and the motion from rest goes there.
inline double border_by_following(const StartedCurve &found) {
  const PlanePoint at = found.point.at;
  const auto count = [&](double omega) {
    return count_at(found.curve, found.point, {omega, at.y});
  };
  const CountJump change = bisect(count, at.x - 3e-7, at.x + 3e-7);
  return 0.5 * (change.below + change.above);
}

// The points behind a change of the count from rest: a multi-sliding bifurcation or a border orbit;
// and, where the motion from rest leaves the orbit for another attractor before its border, the
// place where it does. Throws std::runtime_error where there is none.
inline std::vector<BifurcationPoint> locate(const CountJump &change, int mass) {
  const double check = 0.5 * (change.below + change.above);
  const std::string counting = "bisection on sticking phases from rest";
  if (const auto tangent = multi_sliding(change, mass))
    return {{fmt::format("multi_sliding_mass_{}", mass), *tangent,
             "hold force on the periodic orbit touches zero", check, counting}};
  const StartedCurve found = border_orbit(change, mass);
  BifurcationPoint point{found.start.name,
                         {found.point.at.x, found.point.error},
                         "impact speeds on the periodic orbit keep the ratio of the border orbit",
                         check,
                         counting};
  if (std::abs(point.omega.value - check) < 1e-11) return {point};
  point.check = border_by_following(found);
  point.checked_by = "bisection on sticking phases of the orbit followed";
  const int m = mass;
  const CountJump again = bisect(
      [m](double omega) {
        return sticking_phases(paper::stops_of_different_sign(omega), m, 4 * settling, counted);
      },
      change.below - 1e-9, change.above + 1e-9);
  return {{fmt::format("from_rest_leaves_orbit_mass_{}", mass),
           {check, change.above - change.below},
           counting,
           0.5 * (again.below + again.above),
           "the same after four times as many periods"},
          point};
}

// Sticking phases of both masses in `counted` periods at every frequency of a grid.
using Counts = std::vector<std::array<int, 2>>;

// Sticking phases of both masses in the `counted` periods from `state` on, which is brought to
// their end.
inline std::array<int, 2> sticks_in(const Scene &scene, MotionState &state) {
  EventRecorder recorder;
  state = stroboscopic_map(scene, state, counted, {}, recorder).state;
  std::array<int, 2> sticks{0, 0};
  for (const Event &event : recorder.events)
    if (event.kind == EventKind::stick) ++sticks[static_cast<std::size_t>(event.mass - 1)];
  return sticks;
}

// Every change of the counts of a scan, located, in the order of the frequency; the orbits of one
// kind and mass are numbered from 1.
inline std::vector<BifurcationPoint> locate_all(const std::vector<double> &omegas,
                                                const Counts &counts) {
  std::vector<std::pair<int, std::size_t>> intervals;  // the mass, and the frequency before
  for (std::size_t i = 0; i + 1 < omegas.size(); ++i)
    for (const int mass : {1, 2})
      if (counts[i][static_cast<std::size_t>(mass - 1)] !=
          counts[i + 1][static_cast<std::size_t>(mass - 1)])
        intervals.emplace_back(mass, i);
  std::vector<std::vector<BifurcationPoint>> found(intervals.size());
  in_parallel(intervals.size(), [&](std::size_t k) {
    const auto [mass, left] = intervals[k];
    for (const CountJump &change : changes_between(mass, omegas[left], omegas[left + 1]))
      for (const BifurcationPoint &point : locate(change, mass)) found[k].push_back(point);
  });
  std::vector<BifurcationPoint> points;
  for (const auto &of_interval : found)
    points.insert(points.end(), of_interval.begin(), of_interval.end());
  std::sort(points.begin(), points.end(),
            [](const auto &a, const auto &b) { return a.omega.value < b.omega.value; });
  std::map<std::string, int> numbers;
  for (BifurcationPoint &point : points)
    if (point.symbol.starts_with("border"))
      point.symbol += fmt::format("_{}", ++numbers[std::string(point.symbol)]);
  return points;
}

}  // namespace vibro_impact::figures
