// Event location on the dense output of a Boost.Odeint stepper: a sign change of a guard within a
// step is located on the interpolant (TOMS 748), the stepper is initialised anew behind the event.
//
// Beyond the library's own example (find_crossing: first step with a sign change, then bisection on
// the dense output) the guards are also looked at between the ends of long steps, and the first
// step behind an impact reaches just beyond the flight it begins, so that short flights are not
// jumped.
#pragma once

#include <algorithm>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <cstdint>
#include <exception>
#include <type_traits>

#include "two_masses.hpp"

namespace vibro_impact::comparison {

// Looked at at least this often: a sixteenth of a cycle of the fastest mode (w = 1.618).
constexpr double longest_unseen = 0.25;

constexpr double shortest_step = 1e-15;

// First zero in (a, b] of a guard whose values at the ends are given: positive at or just after a
// and not at b. The end of the bracket where the guard is not positive is returned.
template <class GuardAt>
double first_zero(const GuardAt &guard_at, double a, double at_a, double b, double at_b) {
  if (at_b == 0.0) return b;
  double left = a;
  while (!(at_a > 0.0)) {  // the step starts on the stop
    left = 0.5 * (a + b);
    if (left <= a || left >= b || left - a < shortest_step) return b;
    at_a = guard_at(left);
    if (at_a < 0.0) {
      b = left;
      at_b = at_a;
    }
  }
  std::uintmax_t evaluations = 100;
  return boost::math::tools::toms748_solve(guard_at, left, b, at_a, at_b,
                                           boost::math::tools::eps_tolerance<double>(), evaluations)
      .second;
}

template <class State>
State state_of(const Vec &y) {
  State state;
  if constexpr (!std::is_same_v<State, Vec>) state.resize(4);
  std::copy(y.begin(), y.end(), state.begin());
  return state;
}

// Carries the problem to its end. `system_for(held, evaluations)` is what the stepper integrates.
template <class State, class Stepper, class SystemFor>
Result run_with_dense_output(const Problem &problem, Stepper stepper, double tolerance,
                             const SystemFor &system_for) {
  const TwoMasses chain = two_masses(problem.scene);
  GapState now = gap_state(chain, problem.start);
  Result result;
  const auto system = system_for(chain, now.held, result.work);
  State y = state_of<State>(now.y);
  double cruising = 0.01;
  stepper.initialize(y, now.time, std::min(cruising, 1.1 * flight_ahead(chain, now)));
  bool short_step = true;
  while (result.failure.empty()) {
    auto [from, to] = stepper.do_step(system);
    cruising =
        short_step ? std::max(cruising, stepper.current_time_step()) : stepper.current_time_step();
    short_step = false;
    to = std::min(to, problem.until);
    const int parts = 1 + static_cast<int>((to - from) / longest_unseen);
    double a = from, event = to;
    std::size_t who = 2;
    for (int part = 1; part <= parts && who == 2; ++part) {
      const double b = part == parts ? to : from + (to - from) * part / parts;
      stepper.calc_state(b, y);
      for (std::size_t i = 0; i < 2; ++i) {
        if (guard(chain, now.held, i, y, b) > 0.0) continue;
        const auto guard_at = [&](double t) {
          State between = y;
          stepper.calc_state(t, between);
          return guard(chain, now.held, i, between, t);
        };
        const double zero = first_zero(guard_at, a, guard_at(a), b, guard_at(b));
        if (who == 2 || zero < event) {
          event = zero;
          who = i;
        }
      }
      a = b;
    }
    if (who == 2 && to < problem.until) continue;
    stepper.calc_state(event, y);
    now.time = event;
    std::copy(y.begin(), y.end(), now.y.begin());
    if (who == 2) break;
    happen(chain, now, who, stick_below(tolerance), result);
    const double step = std::min(cruising, 1.1 * flight_ahead(chain, now));
    short_step = step < cruising;
    stepper.initialize(state_of<State>(now.y), now.time, step);
  }
  result.end = physical_state(chain, now);
  return result;
}

// The reason why odeint gave up, as a failure of the run.
template <class Run>
Result guarded(const Run &run_it) {
  try {
    return run_it();
  } catch (const std::exception &error) {
    Result failed;
    failed.failure = error.what();
    return failed;
  }
}

}  // namespace vibro_impact::comparison
