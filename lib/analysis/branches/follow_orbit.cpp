#include "vibro_impact/analysis/follow_orbit.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "follow.hpp"
#include "simulation/for_analysis.hpp"
#include "vibro_impact/analysis/parameter.hpp"

namespace vibro_impact {

namespace {

using namespace branches;

// The units of the unknowns: the range, and the largest coordinate of the orbit.
Problem problem_of(const Scene &scene, const Axis &range, const MotionState &orbit) {
  double length = 0.0;
  for (const double x : orbit.displacement) length = std::max(length, std::abs(x));
  for (const double v : orbit.velocity) length = std::max(length, std::abs(v) / scene.omega);
  return {scene, range.parameter, std::abs(range.to - range.from), length > 0.0 ? length : 1.0};
}

// The first orbit of the branch as a sequence; nothing if Newton's method does not find it.
std::optional<SequenceOrbit> first_orbit(const Problem &problem, const OrbitPoint &found,
                                         int periods) {
  auto first = sequence_from_run(problem, found.orbit.state, periods);
  if (!first) return {};
  auto &[s, u] = *first;
  const double q = u(0);
  if (!solve(problem, s, u, at_parameter(problem, s, q))) return {};
  reduce_period(problem, s, u);
  adapt_chatters(problem, s, u);
  if (!solve(problem, s, u, at_parameter(problem, s, q), true)) return {};
  u(0) = q;  // Newton's method comes to it but for rounding, which may lie beyond its bounds
  return first;
}

}  // namespace

const char *name(BranchPoint kind) {
  constexpr std::array<const char *, 15> names{
      "orbit",         "coincidence",  "fold",   "branching", "flip",
      "torus",         "end of range", "closed", "graze",     "border orbit",
      "multi-sliding", "parent flip",  "jump",   "lost",      "most points"};
  const auto k = static_cast<std::size_t>(kind);
  require(k < names.size(), "kind of a point = ", k, ": there are 0 to ", names.size() - 1);
  return names[k];
}

OrbitPoint find_orbit(const Scene &scene, const MotionState &guess, int periods) {
  OrbitPoint point{.orbit = find_periodic_orbit(scene, guess, periods)};
  if (point.orbit.converged)
    point.counts = counts_of(scene, point.orbit.events, periods, point.orbit.state.held);
  else
    point.kind = BranchPoint::lost;
  return point;
}

void check_range(const Scene &scene, const Axis &range) {
  const double q = get(scene, range.parameter);
  require(!range.parameter.starts_with("displacement") && !range.parameter.starts_with("velocity"),
          range.parameter, ": is an initial state, on which no orbit depends");
  require(range.count >= 2 && range.from != range.to && std::isfinite(range.to - range.from),
          range.parameter, " from ", range.from, " to ", range.to, ", ", range.count,
          " values: must have a finite width and at least 2 values");
  require(std::min(range.from, range.to) <= q && q <= std::max(range.from, range.to),
          range.parameter, " = ", q, ": must lie in the range from ", range.from, " to ", range.to);
}

std::vector<OrbitPoint> follow_orbit(const Scene &scene, const MotionState &guess,
                                     const Axis &range, const FollowOptions &options) {
  check_range(scene, range);
  require(options.most_points >= 1, "most_points = ", options.most_points, ": must be positive");
  OrbitPoint found = find_orbit(scene, guess, options.periods);
  found.parameter = get(scene, range.parameter);
  if (!found.orbit.converged) return {found};
  const Problem problem = problem_of(scene, range, found.orbit.state);
  const auto first = first_orbit(problem, found, options.periods);
  if (!first) {
    found.kind = BranchPoint::lost;
    found.orbit.why_not = "the sequence of its events has no orbit";
    return {found};
  }
  std::vector<OrbitPoint> points;
  for (const Point &point :
       follow(problem, first->first, first->second, range, options.most_points))
    points.push_back(orbit_point_of(problem, point));
  return points;
}

}  // namespace vibro_impact
