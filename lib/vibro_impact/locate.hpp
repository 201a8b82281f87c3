// Locating a parameter value: where a count of events changes, and where a smooth function is zero.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <utility>
#include <vector>

#include "simulate.hpp"

namespace vibro_impact {

// A located parameter value and its estimated absolute error.
struct Located {
  double value = 0.0, error = 0.0;
};

// Sticking phases of `mass` (from 1) begun within `periods` forcing periods, after `settling` ones,
// of the motion from the scene's own initial state.
inline int sticking_phases(const Scene &scene, int mass, int settling, int periods,
                           const RunOptions &options = {}) {
  const Clock clock(scene.omega);
  EventRecorder recorder;
  recorder.from = time_of({settling, 0.0}, clock);
  simulate(scene, time_of({settling + periods, 0.0}, clock), options, recorder);
  return static_cast<int>(std::count_if(
      recorder.events.begin(), recorder.events.end(),
      [mass](const Event &event) { return event.kind == EventKind::stick && event.mass == mass; }));
}

// Two neighbouring parameter values with different counts.
struct Change {
  double below = 0.0, above = 0.0;
  int count_below = 0, count_above = 0;
};

// Bisects [below, above] for the place where `count` first differs from its value at `below`, down
// to `width` (0: neighbouring floating-point numbers). Throws std::invalid_argument when the counts
// at the ends agree.
template <class Count>
Change bisect(Count &&count, double below, double above, double width = 0.0) {
  Change change{below, above, count(below), count(above)};
  if (change.count_below == change.count_above)
    throw std::invalid_argument(fmt::format("count = {} at both {} and {}: no change to locate",
                                            change.count_below, below, above));
  while (change.above - change.below > width) {
    const double middle = 0.5 * (change.below + change.above);
    if (!(change.below < middle && middle < change.above)) break;
    const int counted = count(middle);
    if (counted == change.count_below) {
      change.below = middle;
    } else {
      change.above = middle;
      change.count_above = counted;
    }
  }
  return change;
}

// The zero of f in [below, above], where it changes sign.
template <class Function>
Located zero(Function &&f, double below, double above) {
  std::uintmax_t steps = 100;
  const double at_below = f(below), at_above = f(above);
  if (!(at_below * at_above <= 0.0))
    throw std::invalid_argument(fmt::format("f = {} at {} and {} at {}: no change of sign",
                                            at_below, below, at_above, above));
  if (at_below == 0.0) return {below, 0.0};
  if (at_above == 0.0) return {above, 0.0};
  const auto [a, b] = boost::math::tools::toms748_solve(
      f, below, above, at_below, at_above, boost::math::tools::eps_tolerance<double>(52), steps);
  return {0.5 * (a + b), 0.5 * (b - a)};
}

// The zero of a function that exists, positive and falling, on one side of it only: inverse
// interpolation from that side, never stepping across. `far` and `near` are two points on it,
// f(far) > f(near) > 0. The error estimate is the last correction.
template <class Function>
Located zero_from_one_side(Function &&f, double far, double near) {
  std::vector<std::pair<double, double>> points{{far, f(far)}, {near, f(near)}};
  Located root{near, std::abs(far - near)};
  for (int step = 0; step < 40; ++step) {
    if (!(points.back().second > 0.0) || points.back().second >= points[points.size() - 2].second)
      throw std::runtime_error(fmt::format("f = {} at {}: not falling to zero",
                                           points.back().second, points.back().first));
    // x as a polynomial in f through the last four points, at f = 0.
    const std::size_t first = points.size() > 4 ? points.size() - 4 : 0;
    double estimate = 0.0;
    for (std::size_t i = first; i < points.size(); ++i) {
      double weight = 1.0;
      for (std::size_t j = first; j < points.size(); ++j)
        if (j != i) weight *= points[j].second / (points[j].second - points[i].second);
      estimate += weight * (points[i].first - near);
    }
    estimate += near;
    const double correction = std::abs(estimate - root.value);
    root = {estimate, correction};
    const double distance = estimate - points.back().first;
    if (step > 2 && std::abs(distance) < 1e-10 * std::abs(estimate)) break;
    const double next = estimate - distance / 8;
    points.emplace_back(next, f(next));
  }
  return root;
}

}  // namespace vibro_impact
