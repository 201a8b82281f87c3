// The event loop of every method that steps through smooth motion and has to find the events within
// its steps. A guard that has changed its sign within a step is located on what the method knows of
// the motion between the ends of the step, and the method starts again behind the event.
//
// Odeint's own example, find_crossing, looks at the guards at the ends of a step only. This loop
// also looks at them between the ends of long steps.
#pragma once

#include <algorithm>
#include <boost/math/tools/roots.hpp>
#include <cstdint>
#include <exception>

#include "two_masses.hpp"

namespace vibro_impact::comparison {

// First zero of the guard in (a, b], where it is positive at or just after a and not at b. The end
// of the bracket where the guard is not positive is returned.
template <class GuardAt>
double first_zero(const GuardAt &guard_at, double a, double b) {
  double left = a, at_left = guard_at(a), at_b = guard_at(b);
  if (at_b == 0.0) return b;
  while (!(at_left > 0.0)) {  // The step starts on the stop.
    left = 0.5 * (a + b);
    if (left <= a || left >= b) return b;
    at_left = guard_at(left);
    if (at_left > 0.0) break;
    b = left;
    at_b = at_left;
  }
  namespace tools = boost::math::tools;
  std::uintmax_t evaluations = 100;
  return tools::toms748_solve(guard_at, left, b, at_left, at_b, tools::eps_tolerance<double>(),
                              evaluations)
      .second;
}

// Carries `now`, the state behind the last event, to the time `until`, or as far as there is no
// failure. A method is
//   void restart(double longest_first)  start again at `now`; the first step is no longer than that
//   std::pair<double, double> next()    take a step and return its ends
//   at(double tau)                      the state within the step, or a view of its coordinates
// Its times are counted from `now.time`. The time of an event then has the rounding of t, but the
// place of the event has a rounding as small as the flight is short. There are so many guards, and
// guard(i, y, time) is positive until the next event of its kind. event_of(i) makes that event at
// `now` and returns the longest first step behind it.
template <class Steps, class Now, class Guard, class EventOf>
void advance(Steps &steps, Now &now, double until, double longest_first, std::size_t guards,
             const Guard &guard, const EventOf &event_of, std::string &failure) try {
  steps.restart(longest_first);
  while (failure.empty() && now.time < until) {
    const auto [from, end] = steps.next();
    const double left = until - now.time, to = std::min(end, left);
    const int parts = std::max(1, static_cast<int>((to - from) / longest_unseen + 0.5));
    double a = from, event = to;
    std::size_t first = guards;  // the guard of the first event, or none
    for (int part = 1; part <= parts && first == guards; ++part) {
      const double b = part == parts ? to : from + (to - from) * part / parts;
      const auto at_b = steps.at(b);
      for (std::size_t i = 0; i < guards; ++i) {
        if (guard(i, at_b, now.time + b) > 0.0) continue;
        const auto guard_at = [&](double t) { return guard(i, steps.at(t), now.time + t); };
        if (first != guards && guard_at(event) > 0.0) continue;  // its event comes later
        const double zero = first_zero(guard_at, a, std::min(b, event));
        if (first == guards || zero < event) {
          event = zero;
          first = i;
        }
      }
      a = b;
    }
    if (first == guards && to < left) continue;
    now.y = steps.at(event);
    now.time = first == guards ? until : now.time + event;
    if (first != guards) steps.restart(event_of(first));
  }
} catch (const std::exception &error) {
  failure = error.what();
}

// The first step behind an event reaches just beyond the flight that begins there, so that short
// flights are not jumped over.
constexpr double beyond_the_flight = 1.1;

// The right-hand side at the time tau after the last event, as Odeint calls it.
struct System {
  const TwoMasses &chain;
  const GapState &now;

  template <class Derivative>
  void operator()(const Vec &y, Derivative &&dydt, double tau) const {
    right_hand_side(chain, now.held, y, dydt, now.time + tau);
  }
};

// The motion with its impacts, sticks and releases; a pressed mass sticks when it is slower than
// `slowest`. steps_of(system) makes the method.
template <class StepsOf>
Result with_events(const Problem &problem, double slowest, const StepsOf &steps_of) {
  const TwoMasses chain = two_masses(problem.scene);
  GapState now = gap_state(chain, problem.from, problem.start);
  Result result;
  auto steps = steps_of(System{chain, now});
  advance(
      steps, now, problem.until, flight_ahead(chain, now), 2,
      [&](std::size_t i, const auto &y, double t) { return guard(chain, now.held, i, y, t); },
      [&](std::size_t i) {
        apply_event(chain, now, i, slowest, result);
        return beyond_the_flight * flight_ahead(chain, now);
      },
      result.failure);
  return result;
}

// The length of the next step of a stepper that controls its own. The first step behind an event
// may be shorter than usual, and does not make the usual length shorter.
struct StepLength {
  double usual = 0.01;
  bool shortened = false;

  double first(double longest) {
    shortened = longest < usual;
    return std::min(usual, longest);
  }
  void chosen(double length) {
    usual = shortened ? std::max(usual, length) : length;
    shortened = false;
  }
};

// A dense-output stepper of Odeint as a method.
template <class Stepper, class RightHandSide>
struct DenseOutput {
  const GapState &now;
  Stepper stepper;
  RightHandSide right_hand_side;
  StepLength length = {};

  void restart(double longest_first) {
    stepper.initialize(now.y, 0.0, length.first(longest_first));
  }
  std::pair<double, double> next() {
    const auto ends = stepper.do_step(right_hand_side);
    length.chosen(stepper.current_time_step());
    return ends;
  }
  Vec at(double tau) {
    Vec y;
    stepper.calc_state(tau, y);
    return y;
  }
};

}  // namespace vibro_impact::comparison
