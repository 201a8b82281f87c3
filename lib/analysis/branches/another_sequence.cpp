#include <algorithm>
#include <cmath>
#include <numbers>

#include "sequence.hpp"
#include "simulation/for_analysis.hpp"
#include "tolerances.hpp"

namespace vibro_impact::branches {

namespace {

using Difference = std::ptrdiff_t;

constexpr double same_flight = 1e-9;  // of an orbit and of its half, in radians of the forcing

}  // namespace

void rotate(const Problem &problem, Sequence &s, Vector &u, size_t k) {
  if (k == 0) return;
  const size_t count = s.items.size();
  const State at = inspect(problem, s, u).items[k].after;
  const double turn = s.periods * 2.0 * std::numbers::pi;
  const Vector before = u;
  u(1) = at.angle(0) >= turn ? at.angle(0) - turn : at.angle(0);
  for (size_t i = 0; i < problem.masses(); ++i) {
    u(problem.y_at(i)) = at.y(index(i), 0);
    u(problem.v_at(i)) = at.v(index(i), 0);
  }
  for (size_t j = 0; j < count; ++j)
    u(problem.time_at(j)) = before(problem.time_at((j + k) % count));
  std::rotate(s.items.begin(), s.items.begin() + static_cast<Difference>(k), s.items.end());
}

void re_express(const Problem &problem, const Sequence &from, const Sequence &to, Vector &u) {
  const Model model(problem.scene, problem.parameter, u(0));
  const State before = start_of(problem, model, from, u, 1),
              after = start_of(problem, model, to, u, 1);
  const auto position = [&](int touched) {
    return touched < 0 ? 0.0 : model.stop(touched).position.value;
  };
  for (size_t i = 0; i < problem.masses(); ++i)
    u(problem.y_at(i)) += position(before.touched[i]) - position(after.touched[i]);
}

Vector divided(const Problem &problem, const Vector &u, size_t flight, double offset) {
  const Eigen::Index k = problem.time_at(flight);
  Vector more(u.size() + 1);
  more << u.head(k), offset, u(k) - offset, u.tail(u.size() - k - 1);
  return more;
}

Vector joined(const Problem &problem, const Vector &u, size_t k) {
  const Eigen::Index before = problem.time_at(k - 1);
  Vector fewer(u.size() - 1);
  fewer << u.head(before), u(before) + u(before + 1), u.tail(u.size() - before - 2);
  return fewer;
}

namespace {

// Makes the hold at item k an impact, and the impact a flight later a hold. False if the time left
// to the next event of the mass does not allow it.
bool lengthen_chatter(const Problem &problem, Sequence &s, Vector &u, Vector *tangent, size_t k,
                      double flight) {
  const size_t mass = problem.mass_of(s.items[k]);
  double left = 0.0;
  for (size_t j = k; j < s.items.size(); ++j) {
    left += u(problem.time_at(j));
    if (j + 1 < s.items.size() && problem.mass_of(s.items[j + 1]) == mass) break;
  }
  if (left < flight) return false;
  size_t at = k;  // events of other masses may lie before the next impact
  double offset = flight;
  while (u(problem.time_at(at)) < offset) offset -= u(problem.time_at(at++));
  s.items[k].what = Happening::impact;
  s.items.insert(s.items.begin() + static_cast<Difference>(at + 1),
                 {Happening::hold, s.items[k].stop});
  u = divided(problem, u, at, offset);
  if (tangent) *tangent = divided(problem, *tangent, at, 0.0);
  return true;
}

// Makes the impact before the hold at item k the hold.
void shorten_chatter(const Problem &problem, Sequence &s, Vector &u, Vector *tangent, size_t k) {
  s.items[k - 1].what = Happening::hold;
  s.items.erase(s.items.begin() + static_cast<Difference>(k));
  u = joined(problem, u, k);
  if (tangent) *tangent = joined(problem, *tangent, k);
}

// One change of the chatters. False if none is needed.
bool adapt_one(const Problem &problem, Sequence &s, Vector &u, Vector *tangent) {
  const double rate = rate_bound(problem.scene);
  const Inspection seen = inspect(problem, s, u);
  const Model model(problem.scene, problem.parameter, u(0));
  for (size_t k = 1; k < s.items.size(); ++k) {
    if (s.items[k].what != Happening::hold) continue;
    const ModelStop &stop = model.stop(s.items[k].stop);
    const double speed = rebound(stop, seen.items[k].speed).speed,
                 inverse_mass = model.inverse_mass[stop.mass].value,
                 a = seen.items[k].press * inverse_mass, b = seen.items[k].slope * inverse_mass;
    // The gap w t - a t^2 / 2 - b t^3 / 6 is zero again, in the form without cancellation. Near a
    // border orbit, b t is as large as a.
    const double flight = 2.0 * speed / (0.5 * a + std::sqrt(0.25 * a * a + 2.0 / 3.0 * b * speed));
    if (!(a > 0.0) || !(flight > 0.0)) continue;
    if (flight * rate > last_flight) {
      if (lengthen_chatter(problem, s, u, tangent, k, flight)) return true;
    } else if (k > 1 && s.items[k - 1] == Item{Happening::impact, s.items[k].stop} &&
               u(problem.time_at(k - 1)) * rate < 0.5 * last_flight) {
      shorten_chatter(problem, s, u, tangent, k);
      return true;
    }
  }
  return false;
}

}  // namespace

bool adapt_chatters(const Problem &problem, Sequence &s, Vector &u, Vector *tangent) {
  bool changed = false;
  for (size_t change = 0; change < 400 && adapt_one(problem, s, u, tangent); ++change)
    changed = true;
  return changed;
}

size_t half_of_period(const Problem &problem, const Sequence &s, const Vector &u) {
  if (s.periods % 2 != 0) return 0;
  const double half = 0.5 * u.tail(index(s.items.size())).sum();
  double time = 0.0, nearest = half;
  size_t at = 0;
  for (size_t k = 1; k < s.items.size(); ++k) {
    time += u(problem.time_at(k - 1));
    if (!(s.items[k] == s.items[0]) || !(std::abs(time - half) < nearest)) continue;
    nearest = std::abs(time - half);
    at = k;
  }
  return nearest < half / 4.0 ? at : 0;
}

std::pair<Sequence, Vector> first_half(const Problem &problem, const Sequence &s, const Vector &u) {
  Sequence half = s;
  half.periods /= 2;
  half.items.resize(half_of_period(problem, s, u));
  return {half, u.head(problem.unknowns(half))};
}

bool repeats_after_half(const Problem &problem, const Sequence &s, const Vector &u) {
  const size_t half = half_of_period(problem, s, u);
  if (half == 0 || 2 * half != s.items.size()) return false;
  for (size_t k = 0; k < half; ++k) {
    const double apart = u(problem.time_at(k)) - u(problem.time_at(k + half));
    if (!(s.items[k] == s.items[k + half]) || std::abs(apart) * problem.scene.omega > same_flight)
      return false;
  }
  return true;
}

void reduce_period(const Problem &problem, Sequence &s, Vector &u) {
  while (repeats_after_half(problem, s, u)) std::tie(s, u) = first_half(problem, s, u);
}

MotionState quiet_state(const Problem &problem, const Sequence &s, const Vector &u,
                        const Inspection &seen) {
  const Model model(problem.scene, problem.parameter, u(0));
  const auto times = u.tail(index(s.items.size()));
  Eigen::Index longest = 0;
  times.maxCoeff(&longest);
  State state = seen.items[static_cast<size_t>(longest)].after;
  Flow(model, 3 + 2 * index(problem.masses())).fly(state, 0.5 * times(longest));
  const Clock clock(model.omega.value);
  const double angle = std::fmod(state.angle(0), 2.0 * std::numbers::pi);
  MotionState quiet{.instant = later({}, std::max(angle, 0.0) / model.omega.value, clock)};
  quiet.instant.cycle = 0;
  for (size_t i = 0; i < problem.masses(); ++i) {
    const int touched = state.touched[i], held = state.held[i];
    quiet.displacement.push_back(state.y(index(i), 0) +
                                 (touched < 0 ? 0.0 : model.stop(touched).position.value));
    quiet.velocity.push_back(held < 0 ? state.v(index(i), 0) : 0.0);
    quiet.held.push_back(held < 0 ? static_cast<signed char>(0)
                                  : static_cast<signed char>(model.stop(held).sigma));
  }
  return quiet;
}

}  // namespace vibro_impact::branches
