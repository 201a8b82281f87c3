#include "vibro_impact/analysis/follow_orbit.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "analysis/orbits/orbit_tolerances.hpp"
#include "branch.hpp"
#include "event_counts.hpp"
#include "vibro_impact/analysis/locate.hpp"
#include "vibro_impact/analysis/pressing_force.hpp"

namespace vibro_impact {

namespace {

using Vector = Eigen::VectorXd;

// True if the events of two orbits are the same, from any of them on.
bool same_events(const std::vector<Event> &a, const std::vector<Event> &b) {
  if (a.size() != b.size()) return false;
  std::vector<Event> twice = b;
  twice.insert(twice.end(), b.begin(), b.end());
  // clang 14 does not compile std::ranges::search of libstdc++ 12.
  return a.empty() ||
         std::search(twice.begin(), twice.end(), a.begin(), a.end(), same_kind) != twice.end();
}

// A function of an orbit that changes its sign at a special point of the branch.
using TestFunction = double (*)(const Orbit &);
double at_one(const Orbit &orbit) {
  const Eigen::Index n = orbit.derivative.rows();
  return (Eigen::MatrixXd::Identity(n, n) - orbit.derivative).determinant();
}
double at_minus_one(const Orbit &orbit) {
  const Eigen::Index n = orbit.derivative.rows();
  return (Eigen::MatrixXd::Identity(n, n) + orbit.derivative).determinant();
}
// The complex multiplier of the largest modulus.
double at_unit_circle(const Orbit &orbit) {
  double largest = 0.0;
  for (const auto &multiplier : orbit.point.orbit.multipliers)
    if (multiplier.imag() != 0.0) largest = std::max(largest, std::abs(multiplier));
  return largest - 1.0;
}

// Adds the special points between two orbits, by a search along their chord.
void add_special_points(const Branch &branch, const Orbit &a, const Orbit &b,
                        std::vector<OrbitPoint> &points) {
  const std::array<std::pair<TestFunction, BranchPoint>, 3> kinds{
      {{at_one, BranchPoint::branching},
       {at_minus_one, BranchPoint::flip},
       {at_unit_circle, BranchPoint::torus}}};
  const Vector chord = b.u - a.u, normal = chord.normalized();
  std::vector<std::pair<double, OrbitPoint>> found;
  for (const auto &test_and_kind : kinds) {  // clang 14 captures no structured binding
    const TestFunction test = test_and_kind.first;
    const BranchPoint kind = test_and_kind.second;
    if (!(test(a) * test(b) < 0.0)) continue;
    OrbitPoint nearest;
    double least = infinity, part_of_nearest = 0.0;
    const auto value = [&](double part) {
      const std::optional<Orbit> orbit = branch.orbit_at(a.u + part * chord, normal, chord.norm());
      if (!orbit) throw std::runtime_error("no orbit on the chord");
      const double of_orbit = test(*orbit);
      if (std::abs(of_orbit) < least) {
        least = std::abs(of_orbit);
        part_of_nearest = part;
        nearest = orbit->point;
      }
      return of_orbit;
    };
    try {
      zero(value, 0.0, 1.0);
    } catch (const std::runtime_error &) {
      // The matrix of Newton's method is singular at a branching: the nearest orbit counts.
    }
    if (least > 1e-6 * (std::abs(test(a)) + std::abs(test(b)))) continue;  // a jump
    // At a fold the parameter is greater than on both sides, or smaller.
    const double q = nearest.parameter;
    const bool turns = (q - a.point.parameter) * (q - b.point.parameter) > 0.0;
    nearest.kind = turns && kind == BranchPoint::branching ? BranchPoint::fold : kind;
    found.push_back({part_of_nearest, nearest});
  }
  std::ranges::sort(found, {}, [](const auto &point) { return point.first; });
  for (const auto &[part, point] : found) points.push_back(point);
}

// The kind of the end of a branch of which this is the last orbit. Every condition is relative: a
// gap to the amplitude, the square of a speed to that of the fastest impact, the length of a phase
// to the forcing period, and a force to that of the links over the amplitude.
BranchPoint end_at(const Branch &branch, const Orbit &orbit) {
  const Scene scene = branch.scene_at(orbit.u);
  const int periods = orbit.point.counts.periods;
  const Clock clock(scene.omega);
  double graze = infinity, border = infinity, sliding = infinity, fastest = 0.0;
  for (const Event &event : orbit.events)
    fastest = std::max(fastest, std::abs(event.velocity_before));
  for (const Event &event : orbit.events) {
    if (event.kind == EventKind::impact)
      graze = std::min(graze, std::pow(event.velocity_before / fastest, 2));
    if (event.kind != EventKind::stick) continue;
    // The shortest time to a release at the same stop, around the period.
    for (const Event &release : orbit.events) {
      if (release.kind != EventKind::release || release.stop != event.stop) continue;
      double length = elapsed(event.instant, release.instant, clock);
      if (length < 0.0) length += periods * clock.period;
      border = std::min(border, length / clock.period);
    }
  }
  const double size = branch.unit_of_length();
  const std::vector<double> frequencies = local_frequencies(scene);
  MotionState start = orbit.point.orbit.state;
  for (int period = 0; period < periods; ++period) {
    for (const Stop &stop : scene.stops) {
      const auto i = static_cast<std::size_t>(stop.mass - 1);
      const auto gap = least_gap(scene, start, stop);
      if (gap && gap->value > 0.0)  // 0: the mass leaves its stop
        graze = std::min(graze, gap->value / size);
      if (const auto least = least_pressing_force(scene, start, stop))
        sliding = std::min(
            sliding, std::abs(least->value) / (size * scene.mass[i] * std::pow(frequencies[i], 2)));
    }
    start = stroboscopic_map(scene, start, 1);
  }
  const double nearest = std::min({graze, border, sliding});
  if (!(nearest < near_an_end)) return BranchPoint::lost;
  if (nearest == graze) return BranchPoint::graze;
  return nearest == border ? BranchPoint::border_orbit : BranchPoint::multi_sliding;
}

// The branch from its first orbit on.
std::vector<OrbitPoint> follow(Branch &branch, const OrbitPoint &first, const Axis &range,
                               int most_points) {
  std::vector<OrbitPoint> points = {first};
  const auto ended = [&points](BranchPoint kind) {
    points.back().kind = kind;
    return points;
  };
  branch.set_section(first.orbit.state, first.parameter);
  Eigen::Index q_row = branch.coordinates_free();
  const double longest = 1.0 / static_cast<double>(range.count - 1);
  Vector direction = Vector::Unit(q_row + 1, q_row) * (range.to > range.from ? 1.0 : -1.0);
  std::optional<Orbit> last =
      branch.orbit_at(branch.vector_of(first.orbit.state, first.parameter), direction, longest);
  if (!last) return ended(BranchPoint::lost);
  const auto [least, greatest] = std::minmax(range.from, range.to);
  double step = longest;
  while (static_cast<int>(points.size()) < most_points) {
    Vector guess = last->u + step * direction, normal = direction;
    const double q = branch.parameter(guess), end = direction(q_row) > 0.0 ? greatest : least;
    // A step that ends next to the end of the range goes there: no step leads on.
    const bool at_end = std::clamp(q, least, greatest) != q ||
                        std::abs(end - q) <= least_step * longest * branch.width();
    if (at_end) {
      guess(q_row) = end / branch.width();
      normal = Vector::Unit(q_row + 1, q_row) * std::copysign(1.0, direction(q_row));
    }
    const std::optional<Orbit> next = branch.orbit_at(guess, normal, step);
    // The chords before and after an orbit lie close together, but for the first, which is none.
    const bool smooth = next && same_events(last->events, next->events) &&
                        (points.size() == 1 || step < small_step * longest ||
                         (next->u - last->u).normalized().dot(direction) > least_cosine);
    if (!smooth) {
      step *= 0.5;
      if (step < least_step * longest) return ended(end_at(branch, *last));
      continue;
    }
    add_special_points(branch, *last, *next, points);
    points.push_back(next->point);
    if (at_end) return ended(BranchPoint::end_of_range);
    Orbit before = std::exchange(*last, *next);
    if (!branch.move_section(*last, before)) return ended(BranchPoint::lost);
    q_row = branch.coordinates_free();  // other masses may be held at the new section
    direction = (last->u - before.u).normalized();
    step = std::min(longest, 1.5 * step);
  }
  return ended(BranchPoint::most_points);
}

}  // namespace

const char *name(BranchPoint kind) {
  constexpr std::array<const char *, 11> names{
      "orbit", "fold",         "branching",     "flip", "torus",      "end of range",
      "graze", "border orbit", "multi-sliding", "lost", "most points"};
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
  OrbitPoint first = find_orbit(scene, guess, options.periods);
  first.parameter = get(scene, range.parameter);
  if (!first.orbit.converged) return {first};
  Branch branch(scene, range, options.periods);
  return follow(branch, first, range, options.most_points);
}

}  // namespace vibro_impact
