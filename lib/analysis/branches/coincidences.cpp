#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "simulation/for_analysis.hpp"
#include "tolerances.hpp"
#include "walk.hpp"

namespace vibro_impact::branches {

namespace {

constexpr double same_angle = 0.1;  // of an orbit before and after Newton's method

// The orbit near a guess whose events come in another order: a run from the middle of its longest
// flight says in which. Nothing if the run finds none.
std::optional<SequenceOrbit> reordered(const Problem &problem, const Sequence &s,
                                       const Vector &guess) {
  Problem at = problem;
  at.scene = scene_at(problem, guess(0));
  const MotionState middle = quiet_state(problem, s, guess, inspect(problem, s, guess));
  try {
    std::optional<SequenceOrbit> found = sequence_from_run(at, middle, s.periods);
    if (!found) return {};
    auto &[other, u] = *found;
    const double angle = u(1);
    if (!solve(problem, other, u, at_parameter(problem, other, guess(0)))) return {};
    adapt_chatters(problem, other, u);
    if (!solve(problem, other, u, at_parameter(problem, other, guess(0)))) return {};
    Place place;
    place.sequence = other;
    place.u = u;
    place.seen = inspect(problem, other, u);
    if (!ends_between(problem, place, u, place.seen).empty()) return {};
    if (std::abs(u(1) - angle) > same_angle) return {};
    return found;
  } catch (const std::invalid_argument &) {  // the guess is no state of the scene
    return {};
  } catch (const std::runtime_error &) {  // the run is given up
    return {};
  }
}

}  // namespace

bool exchange(Walk &walk, const End &end) {
  const Problem &problem = walk.problem;
  Sequence s = end.sequence;
  Vector u = end.u;
  size_t k = end.condition.item;
  const size_t count = s.items.size();
  if (k == 0) {
    rotate(problem, s, u, 1);
    k = count - 1;
  }
  const Sequence before = s;
  std::swap(s.items[k], s.items[(k + 1) % count]);
  re_express(problem, before, s, u);
  const Condition no_time{.extra = Extra::no_time, .item = k};
  const bool has_orbit =
      solve(problem, s, u, no_time, true) && std::abs(u(0) - end.u(0)) < exchanged * problem.width;
  if (!has_orbit) {
    const Place place = place_of_end(problem, end);
    const Item &item = end.sequence.items[end.condition.item],
               &next = end.sequence.items[(end.condition.item + 1) % count];
    double error = end.error;
    if (item.what == Happening::hold || next.what == Happening::hold) {
      // The limit of a chatter lies behind its hold, by a flight of the last length or less.
      const double by_time =
          place.direction(0) / place.direction(problem.time_at(end.condition.item));
      error += std::abs(by_time) * last_flight / rate_bound(problem.scene);
    }
    walk.add(BranchPoint::jump, place, error);
    return false;
  }
  // On the new side the flight between the events grows.
  const Eigen::Index time = problem.time_at(k);
  u(time) = std::abs(u(time));
  walk.here = place_of(problem, s, u, Vector::Unit(u.size(), time));
  if (walk.here.direction(time) < 0.0) {
    walk.here.direction = -walk.here.direction;
    walk.here.orientation = -walk.here.orientation;
  }
  walk.before.reset();
  walk.add(BranchPoint::coincidence, walk.here, end.error);
  ++walk.coincidences;
  return true;
}

bool pass_coincidences(Walk &walk) {
  const Place here = walk.here;
  const auto unstable = [](const Multipliers &of) {
    return std::ranges::count_if(of, [](const auto &mu) { return std::abs(mu) > 1.0; });
  };
  for (double far = 0.25 * walk.longest; far > 1e-4 * walk.longest; far /= 4.0) {
    const Vector guess = here.u + far * here.direction;
    if (std::clamp(guess(0), walk.low, walk.high) != guess(0)) continue;
    const auto found = reordered(walk.problem, here.sequence, guess);
    if (!found) continue;
    const auto &[s, u] = *found;
    Place place = place_of(walk.problem, s, u, Vector::Unit(u.size(), 0));
    if (unstable(place.multipliers) != unstable(here.multipliers)) continue;  // a special point
    if (place.direction(0) * here.direction(0) < 0.0) {
      place.direction = -place.direction;
      place.orientation = -place.orientation;
    }
    walk.here = std::move(place);
    walk.before.reset();
    walk.add(BranchPoint::orbit, walk.here);
    walk.step = far;
    return true;
  }
  return false;
}

}  // namespace vibro_impact::branches
