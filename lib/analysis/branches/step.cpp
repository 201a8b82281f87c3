#include <algorithm>
#include <cmath>

#include "tolerances.hpp"
#include "walk.hpp"

namespace vibro_impact::branches {

Place place_of(const Problem &problem, const Sequence &s, const Vector &u, const Vector &along) {
  const Dense jacobian = evaluate(problem, s, u, nullptr, true).jacobian;
  const auto [direction, orientation] = tangent_of(problem, s, jacobian, along);
  return {
      s, u, direction, orientation, multipliers_of(problem, s, jacobian), inspect(problem, s, u)};
}

Place place_of_end(const Problem &problem, const End &end) {
  Place place = place_of(problem, end.sequence, end.u, Vector::Unit(end.u.size(), 0));
  if (end.replaces_impact) place.multipliers.clear();
  return place;
}

double scaled_dot(const Walk &walk, const Vector &a, const Vector &b) {
  const Vector units = units_of(walk.problem, walk.here.sequence);
  return a.cwiseQuotient(units).dot(b.cwiseQuotient(units));
}

Step take_step(const Walk &walk) {
  const Place &here = walk.here;
  Step step;
  Vector guess = here.u + walk.step * here.direction;
  Condition plane = on_plane(walk.problem, here.sequence, guess, here.direction);
  const double end = walk.end_ahead();
  // A step that ends next to the end of the range goes there: no step leads on.
  const double beyond = std::copysign(1.0, here.direction(0)) * (guess(0) - end);
  step.at_end_of_range = beyond >= -least_step * walk.longest * walk.problem.width;
  if (step.at_end_of_range) {
    guess = here.u + (end - here.u(0)) / here.direction(0) * here.direction;
    plane = at_parameter(walk.problem, here.sequence, end);
  }
  step.to.u = guess;
  if (!solve(walk.problem, here.sequence, step.to.u, plane, step.at_end_of_range)) return step;
  const Vector off = step.to.u - guess;
  if (std::sqrt(scaled_dot(walk, off, off)) > farthest_from_guess * walk.step + below_zero)
    return step;
  step.to = place_of(walk.problem, here.sequence, step.to.u, here.direction);
  // Along an arc, the chord has the mean direction of both ends. A chord to another branch has not.
  // An orbit that repeats itself is one of the branch from which the periods were doubled.
  const Vector chord = step.to.u - here.u, mean = here.direction + step.to.direction;
  const double cosine = scaled_dot(walk, step.to.direction, here.direction),
               along = scaled_dot(walk, chord, mean),
               most = std::sqrt(scaled_dot(walk, chord, chord) * scaled_dot(walk, mean, mean));
  step.found = ((cosine >= least_cosine && along >= least_cosine_of_chord * most) ||
                walk.step <= small_step * walk.longest) &&
               !repeats_after_half(walk.problem, step.to.sequence, step.to.u);
  return step;
}

namespace {

// True if a solved end belongs to this step.
bool belongs_to(const Walk &walk, const Step &step, End &end) {
  const double q = walk.here.parameter();
  if (end.guess == Guess::collapse)
    return std::abs(end.u(0) - end.expected) <
           near_collapse * std::abs(end.expected - (step.found ? step.to.u(0) : q));
  const double span = step.found ? step.to.u(0) - q : walk.step * walk.here.direction(0),
               part = span != 0.0 ? (end.u(0) - q) / span : end.part;
  if (end.guess == Guess::at_part) {
    if (std::abs(part - end.part) > far_from_prediction) return false;
  } else {
    const bool after_the_orbit_before =
        walk.before && (end.u(0) - walk.before->parameter()) * span > 0.0;
    if (part > beyond_the_step || (part < -below_zero && !after_the_orbit_before)) return false;
  }
  end.part = part;
  return true;
}

}  // namespace

std::optional<End> nearest_of(const Walk &walk, const Step &step, std::vector<End> ends) {
  std::optional<End> nearest;
  std::ranges::stable_sort(ends, {}, &End::part);
  for (End &end : ends) {
    if (nearest && (end.part > nearest->part + far_behind_an_end ||
                    (end.group != 0 && end.group == nearest->group)))
      continue;
    if (!solve_end(walk.problem, end) || !belongs_to(walk, step, end)) continue;
    const bool at_the_same_place = nearest && end.part < nearest->part + same_part;
    if (!nearest || end.part < nearest->part - same_part ||
        (at_the_same_place && (end.kind == BranchPoint::coincidence || end.error < nearest->error)))
      nearest = std::move(end);
  }
  return nearest;
}

std::vector<End> possible_ends(const Walk &walk, const Step &step) {
  const Place &here = walk.here;
  if (step.found) {
    std::vector<End> ends = ends_between(walk.problem, here, step.to.u, step.to.seen);
    if (ends.empty()) ends = collapses_between(walk.problem, here.sequence, here.u, step.to.u);
    return ends;
  }
  std::vector<End> ends = border_ends(walk.problem, here);
  if (walk.before)
    for (End &end : collapses_between(walk.problem, here.sequence, walk.before->u, here.u))
      ends.push_back(std::move(end));
  return ends;
}

std::optional<Place> last_before_end(const Walk &walk, const Step &step) {
  const Place &here = walk.here;
  double valid = 0.0, invalid = 1.0;
  Vector last = here.u;
  for (int k = 0; k < 10; ++k) {
    const double part = 0.5 * (valid + invalid);
    Vector u = here.u + part * (step.to.u - here.u);
    const Condition plane = on_plane(walk.problem, here.sequence, u, here.direction);
    const bool is_orbit =
        solve(walk.problem, here.sequence, u, plane) &&
        ends_between(walk.problem, here, u, inspect(walk.problem, here.sequence, u)).empty();
    (is_orbit ? valid : invalid) = part;
    if (is_orbit) last = u;
  }
  if (valid == 0.0) return {};
  return place_of(walk.problem, here.sequence, last, here.direction);
}

}  // namespace vibro_impact::branches
