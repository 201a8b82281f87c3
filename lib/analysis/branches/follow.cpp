#include "follow.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "simulation/for_analysis.hpp"
#include "special_points.hpp"
#include "tolerances.hpp"
#include "walk.hpp"

namespace vibro_impact::branches {

namespace {

// Adds the special points before an orbit. False if the branch ends in one.
bool pass_special_points(Walk &walk, const Place &to) {
  const SpecialPoints special = special_points_between(walk.problem, walk.here, to);
  for (const SpecialPoint &point : special.points)
    walk.add(point.kind,
             place_of(walk.problem, point.sequence, point.u,
                      point.u.size() == walk.here.u.size() ? walk.here.direction
                                                           : Vector::Unit(point.u.size(), 0)),
             point.error);
  return !special.ends_the_branch;
}

// True if the branch comes back to its first orbit.
bool is_closed(const Walk &walk) {
  const Place &here = walk.here, &first = walk.first;
  if (walk.points.size() < 4 || !(here.sequence == first.sequence)) return false;
  const Vector back = first.u - here.u;
  const double ahead = scaled_dot(walk, back, here.direction),
               size = std::sqrt(scaled_dot(walk, back, back));
  if (!(size < 1.2 * walk.longest && ahead > 0.9 * size && size > below_zero)) return false;
  Vector u = here.u + ahead * here.direction;
  const Condition plane = on_plane(walk.problem, here.sequence, first.u, here.direction);
  if (!solve(walk.problem, here.sequence, u, plane)) return false;
  const Vector apart = u - first.u;
  return std::sqrt(scaled_dot(walk, apart, apart)) < 1e-7;
}

// Lets the unit of length grow with the orbits. A motion that grows from a small one would take
// ever more steps otherwise.
void renew_unit(Walk &walk) {
  for (const AtItem &item : walk.here.seen.items)
    walk.problem.length = std::max(walk.problem.length, item.after.y.abs().maxCoeff());
  Vector &direction = walk.here.direction;
  direction /= std::sqrt(scaled_dot(walk, direction, direction));
}

// Gives the chatters of the latest orbit the impacts that they need. False if it is lost.
bool adapt(Walk &walk) {
  Place &here = walk.here;
  const Sequence before = here.sequence;
  Sequence s = here.sequence;
  Vector u = here.u, direction = here.direction;
  if (!adapt_chatters(walk.problem, s, u, &direction)) return true;
  if (!solve(walk.problem, s, u, on_plane(walk.problem, s, u, direction))) return false;
  here = place_of(walk.problem, s, u, direction);
  if (walk.points.back().kind == BranchPoint::orbit) walk.points.back().place = here;
  return true;
}

// Shortens the step. False if the branch is lost.
bool shorten(Walk &walk, double factor, const char *why) {
  walk.step *= factor;
  if (walk.step >= least_step * walk.longest) return true;
  return walk.end(BranchPoint::lost,
                  line(why, " within ", walk.step * walk.problem.width, " of the parameter"));
}

// Goes on to an orbit of the same sequence. False if the branch ends.
bool go_on(Walk &walk, const Step &step, const std::optional<End> &collapse) {
  if (!collapse && !pass_special_points(walk, step.to)) return false;
  const std::optional<Place> before = std::exchange(walk.before, walk.here);
  const size_t points = walk.points.size();
  walk.here = step.to;
  walk.coincidences = 0;
  if (collapse) {
    walk.add(BranchPoint::orbit, walk.here);
    walk.add(collapse->kind, place_of_end(walk.problem, *collapse), collapse->error);
    return false;
  }
  walk.add(step.at_end_of_range ? BranchPoint::end_of_range : BranchPoint::orbit, walk.here);
  if (step.at_end_of_range) {  // the rounding of the parameter may lie beyond the range
    Vector &u = walk.points.back().place.u;
    u(0) = std::clamp(u(0), walk.low, walk.high);
    return false;
  }
  if (is_closed(walk)) return walk.end(BranchPoint::closed);
  const Sequence sequence = walk.here.sequence;
  if (!adapt(walk)) {
    walk.here = std::exchange(walk.before, before).value();
    walk.points.resize(points);
    return shorten(walk, 0.3, "the impacts of a chatter are not found");
  }
  if (!(walk.here.sequence == sequence)) walk.before.reset();
  renew_unit(walk);
  walk.step = std::min(walk.longest, 1.5 * walk.step);
  return true;
}

// Takes the next step. False if the branch ends.
bool advance(Walk &walk) {
  if (walk.coincidences > 2) {
    walk.coincidences = 0;
    if (pass_coincidences(walk)) return true;
  }
  const Step step = take_step(walk);
  std::vector<End> ends = possible_ends(walk, step);
  const bool regular = step.found && (ends.empty() || ends.front().guess == Guess::collapse);
  const std::optional<End> nearest = nearest_of(walk, step, std::move(ends));
  // An end that lies at the end of the range does not come before it.
  const bool is_end_of_range =
      nearest && step.found && step.at_end_of_range &&
      std::abs(nearest->u(0) - walk.end_ahead()) < 1e-13 * walk.problem.width;
  if (is_end_of_range) return go_on(walk, step, std::nullopt);
  if (!nearest && !regular)
    return shorten(
        walk, 0.5,
        step.found ? "the events change in a way that no end explains" : "no orbit is found");
  if (!nearest || nearest->guess == Guess::collapse) return go_on(walk, step, nearest);
  if (step.found)
    if (const auto last = last_before_end(walk, step))
      if (!pass_special_points(walk, *last)) return false;
  if (nearest->kind == BranchPoint::coincidence) return exchange(walk, *nearest);
  walk.add(nearest->kind, place_of_end(walk.problem, *nearest), nearest->error);
  return false;
}

}  // namespace

std::vector<Point> follow(const Problem &problem, const Sequence &s, const Vector &u,
                          const Axis &range, int most_points) {
  Place first = place_of(problem, s, u, Vector::Unit(u.size(), 0));
  if (first.direction(0) * (range.to - range.from) < 0.0) {
    first.direction = -first.direction;
    first.orientation = -first.orientation;
  }
  const auto [low, high] = std::minmax(range.from, range.to);
  const double longest = 1.0 / static_cast<double>(range.count - 1);
  Walk walk{problem, low, high, longest, longest, first, {}, first};
  walk.add(BranchPoint::orbit, first);
  try {
    while (static_cast<int>(walk.points.size()) < most_points)
      if (!advance(walk)) return walk.points;
  } catch (const std::runtime_error &given_up) {
    walk.end(BranchPoint::lost, given_up.what());
    return walk.points;
  }
  walk.end(BranchPoint::most_points);
  return walk.points;
}

}  // namespace vibro_impact::branches
