// The event loop: choose a step, find the first event in it, move there, handle it.
#include <algorithm>
#include <cmath>
#include <utility>

#include "instant.hpp"
#include "observers.hpp"
#include "simulation/chain/pair.hpp"
#include "simulation/chain/require.hpp"
#include "simulation/stops/impact.hpp"

namespace vibro_impact::detail {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// The rate in which a chatter is measured: that of the fastest coordinate, or of the time left to
// the limit, to leading order, where nothing but a fall has a rate.
double chatter_rate(const Chatter &chatter, const ContactMode &mode) {
  return mode.falls ? (1.0 - chatter.restitution) / chatter.flight : mode.fastest;
}

// The step to the limit of the chatter under way, if it can be taken there: one that is known well
// enough, without another contact on the way, and with masses that stay pressed.
bool find_limit(Run &run, Step &step) {
  const Chatter &chatter = run.chatter;
  const RunOptions &options = run.problem.options;
  const ContactMode &mode = *run.motion.mode;
  Scratch &scratch = run.scratch;
  // The next impact may come in a little faster than the latest went out.
  for (const std::size_t k : chatter.contacts)
    if (!(next_speed_factor * speed_of(run.stops[mode.contacts[k].stop]) < options.resolve_chatter))
      return false;
  const double rate = chatter_rate(chatter, mode);
  // The speed has the rounding of the 1 / (1 - r) impacts that make it fall by a third.
  const double tolerance =
      options.chatter_tolerance + 4.0 * impact_rounding / std::sqrt(1.0 - chatter.restitution);
  const auto limit = extrapolate_limit(chatter, tolerance / rate);
  if (!limit || !(limit->time_left * rate <= max_step_radians)) return false;
  if (!others_stay_out_of_reach(chatter, run.motion, run.problem.clock.omega, limit->time_left,
                                scratch.change, scratch.speed))
    return false;
  step = {limit->time_left, rate, run.problem.orders.order_of(rate * limit->time_left)};
  ++run.counters.expansions;
  run.counters.coefficients += step.order + 1;
  set_limit_state(chatter, *limit, step, run.problem.clock, run.problem.forced, run.motion,
                  run.stops, scratch.limit);
  if (limit->error * rate + scratch.limit.error > tolerance) return false;
  for (const std::size_t k : chatter.contacts)  // released there: a border orbit or beyond
    if (!(pressing_force(run.scene(), mode.contacts[k], scratch.limit.motion) > 0.0)) return false;
  return true;
}

// Advances a copy of the run through the impacts before the limit: for samples there, or an end.
void look_inside(Run &run, const Instant &limit, Recorders recorders) {
  Run inside = run;
  inside.progress.inside_chatter = true;
  advance(inside, std::min(run.progress.end, limit), recorders);
  run.modes = std::move(inside.modes);
  run.counters.modal_evaluations = inside.counters.modal_evaluations;
  run.counters.modes_built = inside.counters.modes_built;
  if (run.progress.end < limit || inside.progress.ending != Ending::reached) {
    run.progress = std::move(inside.progress);
    run.progress.inside_chatter = false;
  }
}

// Carries a chatter that has come to a node of its table to its limit.
void take_limit(Run &run, Recorders recorders) {
  Step step;
  if (run.progress.over || run.progress.inside_chatter || !run.chatter.stands_at_node() ||
      !find_limit(run, step))
    return;
  const Instant limit = run.scratch.limit.motion.now;
  if (run.progress.end < limit || next_sample(recorders) <= time_of(limit, run.problem.clock)) {
    look_inside(run, limit, recorders);
    if (run.progress.over) return;
  }
  std::swap(run.motion, run.scratch.limit.motion);
  std::swap(run.stops, run.scratch.limit.stops);
  end(run.chatter);
  run.hint = {};
  ++run.counters.chatter_limits;
  run.scratch.hits.clear();
  run.scratch.roots.clear();
  hold_or_release(run, recorders);
}

void give_up_beyond_range(Run &run) {
  const Motion &motion = run.motion;
  if (!std::isfinite(total(motion.y, motion.dy)))
    stop_run(run, Ending::given_up,
             line("the motion leaves the range of double precision before t = ",
                  time_of(motion.now, run.problem.clock), ", given up"));
}

Step plan_step(Run &run) {
  const double rate = rate_in_motion(run.motion), longest = max_step_radians / rate;
  // Flights may be short without bound (r = 1e-300), steps not: slope * length must not underflow.
  double length =
      std::min(longest, std::max(expected_flight_margin * run.hint.flight, negligible * longest));
  const double phase = run.motion.now.phase;
  if (run.hint.postponed)  // to the next instant of the clock
    length = 2.0 * (std::nextafter(phase, infinity) - phase);
  const Step step{length, rate, run.problem.orders.order_of(rate * length)};
  ++run.counters.expansions;
  run.counters.coefficients += step.order + 1;
  return step;
}

// Serves the samples up to `tau` after the motion: along the step at hand, or in closed form on a
// flight on which no event can be.
void sample(Run &run, double tau, bool in_closed_form, Recorders recorders) {
  const Clock &clock = run.problem.clock;
  Scratch &scratch = run.scratch;
  for (double next = next_sample(recorders); next < infinity; next = next_sample(recorders)) {
    const Instant instant = instant_at(next, clock);
    const double since = time_until(run.motion, instant, clock), after = std::max(0.0, since);
    if (after > tau) return;
    require(since >= -16.0 * std::numeric_limits<double>::epsilon() * next, "next_time = ", next,
            ": lies before the motion, which is at t = ", time_of(run.motion.now, clock));
    scratch.sampled = run.motion;
    scratch.sampled_stops = run.stops;
    if (in_closed_form)
      fly_along(instant, clock, scratch.sampled, scratch.sampled_stops, scratch.change);
    else
      move_along(scratch.flight, after / scratch.flight.step.length, clock, scratch.sampled,
                 scratch.sampled_stops);
    ++run.counters.modal_evaluations;
    if (!report_sample(scratch.sampled, next, clock, recorders)) continue;
    set_state(scratch.sampled, scratch.sampled_stops, run.scene(), run.progress.last);
    run.progress.last.instant = instant;
    return stop_run(run, Ending::stopped);
  }
}

// Ends the run at its end, `tau` after the motion, which stays where it is.
void end_at_time(Run &run, double tau, bool in_closed_form, Recorders recorders) {
  sample(run, tau, in_closed_form, recorders);
  if (run.progress.over) return;
  Scratch &scratch = run.scratch;
  scratch.sampled = run.motion;
  scratch.sampled_stops = run.stops;
  if (in_closed_form) {
    fly_along(run.progress.end, run.problem.clock, scratch.sampled, scratch.sampled_stops,
              scratch.change);
    ++run.counters.modal_evaluations;
  } else {
    move_along(scratch.flight, tau / scratch.flight.step.length, run.problem.clock, scratch.sampled,
               scratch.sampled_stops);
  }
  set_state(scratch.sampled, scratch.sampled_stops, run.scene(), run.progress.last);
  run.progress.last.instant = run.progress.end;
  stop_run(run, Ending::reached);
  for (const double x : run.progress.last.displacement)
    if (!std::isfinite(x)) {
      run.progress.ending = Ending::given_up;
      run.progress.reason = line("the motion leaves the range of double precision before t = ",
                                 time_of(run.progress.end, run.problem.clock), ", given up");
    }
}

// Flies on in closed form where no event can be for a long time; true when it did.
bool fly_quietly(Run &run, double remaining, Recorders recorders) {
  const Clock &clock = run.problem.clock;
  if (!run.hint.quiet) return false;
  const double quiet = quiet_time(run.motion, run.stops, clock.omega);
  const double length = 0.5 * quiet;
  if (!(length * rate_in_motion(run.motion) > quiet_steps * max_step_radians)) return false;
  // Whether it flies so must not depend on where the run ends.
  if (length > remaining) {
    end_at_time(run, remaining, true, recorders);
    return true;
  }
  const Instant target = later(run.motion.now, length, clock);
  const double tau = time_until(run.motion, target, clock);
  sample(run, tau, true, recorders);
  if (run.progress.over) return true;
  fly_along(target, clock, run.motion, run.stops, run.scratch.change);
  run.chatter.since += tau;
  return true;
}

// One step of the loop.
void run_step(Run &run, Recorders recorders) {
  const Clock &clock = run.problem.clock;
  const double remaining = std::max(0.0, time_until(run.motion, run.progress.end, clock));
  give_up_beyond_range(run);
  if (run.progress.over || fly_quietly(run, remaining, recorders)) return;
  Flight &flight = run.scratch.flight;
  flight.step = plan_step(run);
  find_first_event(run.motion, run.stops, clock, run.problem.forced, run.problem.rate_bound, flight,
                   run.counters);
  const double tau = flight.u * flight.step.length;
  if (tau > remaining || remaining == 0.0) return end_at_time(run, remaining, false, recorders);
  sample(run, tau, false, recorders);
  if (run.progress.over) return;
  move_along(flight, flight.u, clock, run.motion, run.stops);
  run.chatter.since += tau;
  run.hint = {.quiet = !flight.any_near || (run.motion.mode->drift >= 0 && !flight.event)};
  if (!flight.event) return;
  handle_instant(run, recorders);
  take_limit(run, recorders);
}

}  // namespace

void advance(Run &run, const Instant &end, Recorders recorders) {
  run.progress = {.end = end, .inside_chatter = run.progress.inside_chatter};
  if (run.start) handle_start(run, recorders);
  take_limit(run, recorders);  // also of a chatter that stood at a node when the run ended
  while (!run.progress.over) {
    run_step(run, recorders);
    if (!run.progress.over && !recorders.empty() && is_done(recorders))
      stop_run(run, Ending::stopped);
  }
  // A run that ends at an event ends where it stands.
  if (run.progress.last.displacement.empty())
    set_state(run.motion, run.stops, run.scene(), run.progress.last);
}

}  // namespace vibro_impact::detail
