// The loop of every method that steps through smooth motion and has to find the events within its
// steps: a guard that has changed its sign within a step is located on what the method has between
// the ends of it, and the method begins anew behind the event.
//
// Beyond Odeint's own example (find_crossing: first step with a sign change, then bisection on the
// dense output) the guards are also looked at between the ends of long steps.
#pragma once

#include <algorithm>
#include <boost/math/tools/roots.hpp>
#include <cstdint>
#include <exception>

#include "two_masses.hpp"

namespace vibro_impact::comparison {

// How a zero is narrowed down once it is bracketed.
enum class Search { toms748, bisection };

// First zero of the guard in (a, b], where it is positive at or just after a and not at b. The end
// of the bracket where the guard is not positive is returned.
template <class GuardAt>
double first_zero(const GuardAt &guard_at, double a, double b, Search search) {
  double at_a = guard_at(a), at_b = guard_at(b);
  if (at_b == 0.0) return b;
  double left = a;
  while (!(at_a > 0.0)) {  // the step starts on the stop
    left = 0.5 * (a + b);
    if (left <= a || left >= b) return b;
    at_a = guard_at(left);
    if (at_a > 0.0) break;
    b = left;
    at_b = at_a;
  }
  namespace tools = boost::math::tools;
  const tools::eps_tolerance<double> to_rounding;
  std::uintmax_t evaluations = 100;
  return search == Search::bisection
             ? tools::bisect(guard_at, left, b, to_rounding, evaluations).second
             : tools::toms748_solve(guard_at, left, b, at_a, at_b, to_rounding, evaluations).second;
}

// Carries `now`, the state behind the last event, to the time `until`, or as far as there is no
// failure. A method is
//   void restart(double at_most)       begin anew at `now`, with a first step of at most
//   std::pair<double, double> next()   take a step: its ends
//   Vec at(double tau)                 the state within the step
// with times counted from `now.time`: of two roundings, that of the time of an event and that of
// its place, the second then is as small as the flight is short. guard(i, y, time) is positive
// until the next event of mass i + 1, and happens(i), at `now`, makes that event and returns the
// longest first step behind it.
template <class Steps, class Guard, class Happens>
void follow(Steps &steps, GapState &now, double until, double at_most, const Guard &guard,
            const Happens &happens, std::string &failure, Search search = Search::toms748) try {
  constexpr std::size_t nobody = 2;
  steps.restart(at_most);
  while (failure.empty() && now.time < until) {
    const auto [from, end] = steps.next();
    const double left = until - now.time, to = std::min(end, left);
    const int parts = std::max(1, static_cast<int>((to - from) / longest_unseen + 0.5));
    double a = from, event = to;
    std::size_t who = nobody;
    for (int part = 1; part <= parts && who == nobody; ++part) {
      const double b = part == parts ? to : from + (to - from) * part / parts;
      const Vec at_b = steps.at(b);
      for (std::size_t i = 0; i < 2; ++i) {
        if (guard(i, at_b, now.time + b) > 0.0) continue;
        const auto guard_at = [&](double t) { return guard(i, steps.at(t), now.time + t); };
        const double zero = first_zero(guard_at, a, b, search);
        if (who == nobody || zero < event) {
          event = zero;
          who = i;
        }
      }
      a = b;
    }
    if (who == nobody && to < left) continue;
    now.y = steps.at(event);
    now.time = who == nobody ? until : now.time + event;
    if (who != nobody) steps.restart(happens(who));
  }
} catch (const std::exception &error) {
  failure = error.what();
}

// The first step behind an event reaches just beyond the flight it begins, so that short flights
// are not jumped.
constexpr double beyond_the_flight = 1.1;

// The motion with its impacts, sticks and releases. steps_of(chain, now, work) makes the method.
template <class StepsOf>
Result with_events(const Problem &problem, double slowest, const StepsOf &steps_of,
                   Search search = Search::toms748) {
  const TwoMasses chain = two_masses(problem.scene);
  GapState now = gap_state(chain, problem.start);
  Result result;
  auto steps = steps_of(chain, now, result.work);
  follow(
      steps, now, problem.until, flight_ahead(chain, now),
      [&](std::size_t i, const Vec &y, double t) { return guard(chain, now.held, i, y, t); },
      [&](std::size_t i) {
        happen(chain, now, i, slowest, result);
        return beyond_the_flight * flight_ahead(chain, now);
      },
      result.failure, search);
  result.end = physical_state(chain, now);
  return result;
}

// The length of the next step of a stepper that controls its own, but for the first behind an
// event, which may be shorter.
struct StepLength {
  double usual = 0.01;
  bool shortened = false;

  double first(double at_most) {
    shortened = at_most < usual;
    return std::min(usual, at_most);
  }
  void chosen(double length) {
    usual = shortened ? std::max(usual, length) : length;
    shortened = false;
  }
};

// A dense-output stepper of Odeint as a method.
template <class State, class Stepper, class System>
struct DenseOutput {
  const GapState &now;
  Stepper stepper;
  System system;
  State between = {};
  StepLength length = {};

  void restart(double at_most) {
    std::copy(now.y.begin(), now.y.end(), between.begin());
    stepper.initialize(between, 0.0, length.first(at_most));
  }
  std::pair<double, double> next() {
    const auto ends = stepper.do_step(system);
    length.chosen(stepper.current_time_step());
    return ends;
  }
  Vec at(double tau) {
    stepper.calc_state(tau, between);
    Vec y;
    std::copy(between.begin(), between.end(), y.begin());
    return y;
  }
};

}  // namespace vibro_impact::comparison
