#include "vibro_impact/analysis/follow_orbit.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "analysis/orbits/orbit_tolerances.hpp"
#include "branch.hpp"
#include "settled_runs.hpp"
#include "vibro_impact/analysis/locate.hpp"
#include "vibro_impact/analysis/pressing_force.hpp"

namespace vibro_impact {

namespace {

using Vector = Eigen::VectorXd;

double determinant(const Eigen::MatrixXd &matrix) {
  return matrix.rows() == 0 ? 1.0 : matrix.determinant();
}

// True if the events of two orbits are the same, from any of them on.
bool same_events(const std::vector<Event> &a, std::vector<Event> b) {
  if (a.size() != b.size()) return false;
  for (std::size_t k = 0; k < a.size(); ++k) {
    if (std::ranges::equal(a, b, same_kind)) return true;
    std::rotate(b.begin(), b.begin() + 1, b.end());
  }
  return a.empty();
}

OrbitPoint point_of(const Branch &branch, const Orbit &orbit, BranchPoint kind) {
  OrbitPoint point{branch.parameter(orbit.u), {}, orbit.counts, kind};
  point.orbit.state = orbit.state;
  point.orbit.multipliers = orbit.multipliers;
  point.orbit.converged = true;
  point.orbit.residuals = {orbit.residual * branch.unit_of_length()};
  point.orbit.events = orbit.all_events;
  return point;
}

// A function of an orbit that changes its sign at a special point of the branch.
using Sign = double (*)(const Orbit &);
double at_one(const Orbit &orbit) {
  const Eigen::Index n = orbit.derivative.rows();
  return determinant(Eigen::MatrixXd::Identity(n, n) - orbit.derivative);
}
double at_minus_one(const Orbit &orbit) {
  const Eigen::Index n = orbit.derivative.rows();
  return determinant(Eigen::MatrixXd::Identity(n, n) + orbit.derivative);
}
// The complex multiplier of the largest modulus.
double at_unit_circle(const Orbit &orbit) {
  double largest = 0.0;
  for (const auto &multiplier : orbit.multipliers)
    if (multiplier.imag() != 0.0) largest = std::max(largest, std::abs(multiplier));
  return largest - 1.0;
}

// Adds the special points between two orbits, by a search along their chord.
void add_special_points(const Branch &branch, const Orbit &a, const Orbit &b,
                        std::vector<OrbitPoint> &points) {
  const std::array<std::pair<Sign, BranchPoint>, 3> kinds{{{at_one, BranchPoint::branching},
                                                           {at_minus_one, BranchPoint::flip},
                                                           {at_unit_circle, BranchPoint::torus}}};
  const Vector chord = b.u - a.u, normal = chord.normalized();
  std::vector<std::pair<double, std::pair<Orbit, BranchPoint>>> found;
  for (const auto &sign_and_kind : kinds) {  // clang 14 captures no structured binding
    const Sign sign_of = sign_and_kind.first;
    const BranchPoint kind = sign_and_kind.second;
    if (!(sign_of(a) * sign_of(b) < 0.0)) continue;
    Orbit nearest;
    double least = infinity, part_of_nearest = 0.0;
    const auto value = [&](double part) {
      const std::optional<Orbit> orbit = branch.orbit_at(a.u + part * chord, normal);
      if (!orbit) throw std::runtime_error("no orbit on the chord");
      const double sign = sign_of(*orbit);
      if (std::abs(sign) < least) {
        least = std::abs(sign);
        part_of_nearest = part;
        nearest = *orbit;
      }
      return sign;
    };
    try {
      zero(value, 0.0, 1.0);
    } catch (const std::runtime_error &) {
      // The matrix of Newton's method is singular at a branching: the nearest orbit counts.
    }
    if (least > 1e-6 * (std::abs(sign_of(a)) + std::abs(sign_of(b)))) continue;  // a jump
    // At a fold the parameter is greater than on both sides, or smaller.
    const double q = branch.parameter(nearest.u);
    const bool turns = (q - branch.parameter(a.u)) * (q - branch.parameter(b.u)) > 0.0;
    found.push_back(
        {part_of_nearest,
         {nearest, turns && kind == BranchPoint::branching ? BranchPoint::fold : kind}});
  }
  std::ranges::sort(found, {}, [](const auto &point) { return point.first; });
  for (const auto &[part, point] : found)
    points.push_back(point_of(branch, point.first, point.second));
}

// The kind of the end of a branch of which this is the last orbit. Every condition is relative: a
// gap to the amplitude, the square of a speed to that of the fastest impact, the length of a phase
// to the forcing period, and a force to that of the links over the amplitude.
BranchPoint end_at(const Branch &branch, const Orbit &orbit) {
  const Scene scene = branch.scene_at(orbit.u);
  const int periods = orbit.counts.periods;
  const Clock clock(scene.omega);
  std::array<std::pair<double, BranchPoint>, 3> ends{{{infinity, BranchPoint::graze},
                                                      {infinity, BranchPoint::border_orbit},
                                                      {infinity, BranchPoint::multi_sliding}}};
  const auto note = [&ends](std::size_t k, double value) {
    ends[k].first = std::min(ends[k].first, value);
  };
  double fastest = 0.0;
  for (const Event &event : orbit.events)
    fastest = std::max(fastest, std::abs(event.velocity_before));
  std::vector<Event> twice = orbit.events;
  twice.insert(twice.end(), orbit.events.begin(), orbit.events.end());
  for (std::size_t k = 0; k < twice.size(); ++k) {
    const Event &event = twice[k];
    if (event.kind == EventKind::impact) note(0, std::pow(event.velocity_before / fastest, 2));
    if (event.kind != EventKind::stick || k >= orbit.events.size()) continue;
    const auto release = std::find_if(
        twice.begin() + static_cast<std::ptrdiff_t>(k), twice.end(), [&event](const Event &of) {
          return of.kind == EventKind::release && of.stop == event.stop;
        });
    if (release == twice.end()) continue;
    double length = elapsed(event.instant, release->instant, clock);
    if (length < 0.0) length += periods * clock.period;
    note(1, length / clock.period);
  }
  const double size = branch.unit_of_length();
  const std::vector<double> frequencies = local_frequencies(scene);
  MotionState start = orbit.state;
  for (int period = 0; period < periods; ++period) {
    for (const Stop &stop : scene.stops) {
      const auto i = static_cast<std::size_t>(stop.mass - 1);
      const auto gap = least_gap(scene, start, stop);
      if (gap && gap->value > 0.0) note(0, gap->value / size);  // 0: the mass leaves its stop
      if (const auto least = least_pressing_force(scene, start, stop))
        note(2, std::abs(least->value) / (size * scene.mass[i] * std::pow(frequencies[i], 2)));
    }
    start = stroboscopic_map(scene, start, 1);
  }
  const auto nearest = std::ranges::min(ends, {}, [](const auto &end) { return end.first; });
  return nearest.first < near_an_end ? nearest.second : BranchPoint::lost;
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
  const Eigen::Index q_row = branch.coordinates_free();
  const double longest = 1.0 / static_cast<double>(range.count - 1);
  Vector direction = Vector::Unit(q_row + 1, q_row) * (range.to > range.from ? 1.0 : -1.0);
  std::optional<Orbit> last =
      branch.orbit_at(branch.vector_of(first.orbit.state, first.parameter), direction);
  if (!last) return ended(BranchPoint::lost);
  double step = longest;
  while (static_cast<int>(points.size()) < most_points) {
    Vector guess = last->u + step * direction, normal = direction;
    const double q = branch.parameter(guess), bound = std::clamp(q, std::min(range.from, range.to),
                                                                 std::max(range.from, range.to));
    if (q != bound) {
      guess(q_row) = bound / branch.width();
      normal = Vector::Unit(q_row + 1, q_row) * std::copysign(1.0, direction(q_row));
    }
    const std::optional<Orbit> next = branch.orbit_at(guess, normal);
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
    points.push_back(point_of(branch, *next, BranchPoint::orbit));
    if (q != bound) return ended(BranchPoint::end_of_range);
    Orbit before = std::exchange(*last, *next);
    if (!branch.move_section(*last, before)) return ended(BranchPoint::lost);
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

std::vector<OrbitPoint> follow_orbit(const Scene &scene, const MotionState &guess,
                                     const Axis &range, const FollowOptions &options) {
  const double q = get(scene, range.parameter);
  require(range.count >= 2 && range.from != range.to && std::isfinite(range.to - range.from),
          range.parameter, " from ", range.from, " to ", range.to, ", ", range.count,
          " values: must have a finite width and at least 2 values");
  require(std::min(range.from, range.to) <= q && q <= std::max(range.from, range.to),
          range.parameter, " = ", q, ": must lie in the range from ", range.from, " to ", range.to);
  require(options.most_points >= 1, "most_points = ", options.most_points, ": must be positive");
  OrbitPoint first = find_orbit(scene, guess, options.periods);
  first.parameter = q;
  if (!first.orbit.converged) return {first};
  Branch branch(scene, range, options.periods);
  return follow(branch, first, range, options.most_points);
}

}  // namespace vibro_impact
