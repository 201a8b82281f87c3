// Boost.Odeint's runge_kutta_fehlberg78, which has no dense output: an event within a step is
// located by repeating the step from its beginning with the trial length (TOMS 748 on the length).
#include <fmt/format.h>

#include <algorithm>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <cmath>

#include "odeint_events.hpp"

namespace vibro_impact::comparison {

namespace {

namespace odeint = boost::numeric::odeint;

// The guards are looked at at the ends of steps only, so steps stay below a sixteenth of a cycle
// of the fastest mode (w = 1.618).
constexpr double longest_step = 0.25;

Result fehlberg(const Problem &problem, double tolerance) {
  const TwoMasses chain = two_masses(problem.scene);
  GapState now = gap_state(chain, problem.start);
  Result result;
  const auto system = [&](const Vec &y, Vec &dydt, double t) {
    ++result.work;
    right_hand_side(chain, now.held, y, dydt, t);
  };
  using Stepper = odeint::runge_kutta_fehlberg78<Vec>;
  auto controlled = odeint::make_controlled(tolerance, tolerance, Stepper());
  Stepper plain;
  double cruising = 0.01, step = std::min(cruising, 1.1 * flight_ahead(chain, now));
  while (now.time < problem.until && result.failure.empty()) {
    const bool short_step = step < cruising, last = step >= problem.until - now.time;
    double dt = last ? problem.until - now.time : step, taken = dt, time = now.time;
    Vec y;
    while (controlled.try_step(system, now.y, time, y, dt) == odeint::fail) taken = dt;
    cruising = std::min(longest_step, short_step || last ? std::max(cruising, dt) : dt);
    step = cruising;
    double event = taken;
    std::size_t who = 2;
    for (std::size_t i = 0; i < 2; ++i) {
      const double at_end = guard(chain, now.held, i, y, now.time + taken);
      if (at_end > 0.0) continue;
      const auto guard_after = [&](double tau) {
        Vec between;
        plain.do_step(system, now.y, now.time, between, tau);
        return guard(chain, now.held, i, between, now.time + tau);
      };
      const double at_start = guard(chain, now.held, i, now.y, now.time);
      const double zero = first_zero(guard_after, 0.0, at_start, taken, at_end);
      if (who == 2 || zero < event) {
        event = zero;
        who = i;
      }
    }
    if (who != 2) plain.do_step(system, now.y, now.time, y, event);
    now.time =
        who == 2 && last && taken == problem.until - now.time ? problem.until : now.time + event;
    now.y = y;
    if (who == 2) continue;
    happen(chain, now, who, stick_below(tolerance), result);
    step = std::min(cruising, 1.1 * flight_ahead(chain, now));
  }
  result.end = physical_state(chain, now);
  return result;
}

}  // namespace

std::vector<Method> odeint_without_dense_output() {
  return {{"odeint runge_kutta_fehlberg78",
           "tolerance",
           "right-hand sides",
           {1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-14},
           fehlberg}};
}

}  // namespace vibro_impact::comparison
