// The event loop chooses a step, finds the first event in it, moves there and handles the event.
#include <algorithm>
#include <cmath>
#include <utility>

#include "events_at_an_instant.hpp"
#include "observers.hpp"
#include "samples.hpp"
#include "simulation/chain/pair.hpp"
#include "simulation/chain/require.hpp"
#include "simulation/chain/tolerances.hpp"
#include "simulation/flight/quiet_flight.hpp"
#include "simulation/stops/impact.hpp"

namespace vibro_impact::detail {

namespace {

// A step of this length, which is counted as work.
Step make_step(Run &run, double length, double rate) {
  const Step step{length, rate, run.problem.orders.order_of(rate * length)};
  ++run.counters.expansions;
  run.counters.coefficients += step.order + 1;
  return step;
}

// Finds the limit of the chatter under way and sets the state there, in scratch.limit. Returns
// false when the limit is not accurate enough, when another contact may come to zero before it, or
// when a mass hit is not pressed against its stop there. The errors of the time of the limit (in
// the unit of time of the impacts) and of the state add up to at most the tolerance.
bool find_limit(Run &run) {
  const Chatter &chatter = run.chatter;
  const RunOptions &options = run.problem.options;
  const ContactMode &mode = *run.motion.mode;
  LimitState &state = run.scratch.limit;
  double unit = 0.0;
  for (const std::size_t k : chatter.contacts) {
    const StopState &stop = run.stops[mode.contacts[k].stop];
    // The closing speed of the next impact may be a little above the latest rebound speed.
    const double speed = stop.contact.speed.value_or(0.0);
    if (!(next_speed_factor * speed < options.limit_below_speed)) return false;
    unit = std::max(unit, unit_of_time(mode, stop));
  }
  // The impact speed falls to a third over 1 / (1 - r) impacts and has the rounding of these.
  const double tolerance =
      options.chatter_tolerance + 4.0 * impact_rounding / std::sqrt(1.0 - chatter.restitution);
  const auto limit = extrapolate_limit(chatter, tolerance * unit);
  if (!limit || (!mode.falls && !(limit->time_left * mode.fastest <= max_step_radians)))
    return false;
  if (!others_stay_out_of_reach(chatter, run.motion, run.stops, run.problem.clock.omega,
                                limit->time_left, state))
    return false;
  set_limit_state(chatter, *limit, run.problem.clock, run.motion, run.stops, state);
  if (limit->error / unit + state.error > tolerance) return false;
  // A mass that is not pressed is on a border orbit or beyond.
  return std::all_of(chatter.contacts.begin(), chatter.contacts.end(), [&](std::size_t k) {
    return pressing_force(run.scene(), mode.contacts[k], state.motion, 0.0) > 0.0;
  });
}

// Moves the run to the limit of a chatter whose latest impact is a node of its table, if the limit
// is found.
void take_limit(Run &run, Recorders recorders) {
  if (run.progress.over || run.progress.inside_chatter || !run.chatter.stands_at_node() ||
      !find_limit(run))
    return;
  const Instant limit = run.scratch.limit.motion.now;
  if (run.progress.end < limit || run.progress.next_sample <= time_of(limit, run.problem.clock)) {
    look_inside(run, limit, recorders);
    if (run.progress.over) return;
  }
  std::swap(run.motion, run.scratch.limit.motion);
  std::swap(run.stops, run.scratch.limit.stops);
  end_chatter(run.chatter);
  run.hint = {};
  ++run.counters.chatter_limits;
  hold_or_release(run, {}, recorders);
}

// The longest step at this rate in motion. A step without a rate is exact at any length and is as
// long as the time before.
double longest_step_at(double rate, const Run &run) {
  if (rate > 0.0) return std::min(max_step_radians / rate, longest_step);
  return std::max(max_step_radians / run.motion.mode->fastest,
                  time_of(run.motion.now, run.problem.clock));
}

Step plan_step(Run &run) {
  const double rate = rate_in_motion(run.motion), longest = longest_step_at(rate, run);
  // A flight may be shorter than any bound (r = 1e-300). A step may not: the product of a slope and
  // its length must not underflow.
  double length = std::min(
      longest, std::max(expected_flight_margin * run.hint.flight_time, negligible * longest));
  const double phase = run.motion.now.phase;
  if (run.hint.postponed)  // the decision is made at the next instant of the clock
    length = 2.0 * (std::nextafter(phase, infinity) - phase);
  return make_step(run, length, rate);
}

// Flies on in closed form if no event can follow for many steps. Returns true if it did.
bool fly_quietly(Run &run, double remaining, Recorders recorders) {
  const Clock &clock = run.problem.clock;
  if (!run.hint.quiet) return false;
  const double quiet = quiet_time(run.motion, run.stops, clock.omega);
  const double length = 0.5 * quiet;
  if (!(length > quiet_steps * longest_step_at(rate_in_motion(run.motion), run))) return false;
  // The end of the call must not decide whether the run flies in closed form.
  if (length > remaining) {
    end_at_time(run, remaining, true, recorders);
    return true;
  }
  const Instant target = later(run.motion.now, length, clock);
  const double tau = time_until(run.motion, target, clock);
  sample(run, tau, true, recorders);
  if (run.progress.over) return true;
  fly(run.motion, clock, target);
  forget_instant(run.stops);
  run.chatter.since += tau;
  return true;
}

// One step of the loop.
void run_step(Run &run, Recorders recorders) {
  const Clock &clock = run.problem.clock;
  const double remaining = std::max(0.0, time_until(run.motion, run.progress.end, clock));
  if (!(sum_of_moduli(run.motion.y, run.motion.dy) <= largest_motion))
    give_up_beyond_range(run, run.motion.now);
  if (run.progress.over || fly_quietly(run, remaining, recorders)) return;
  Flight &flight = run.scratch.flight;
  flight.step = plan_step(run);
  find_first_event(run.motion, run.stops, clock, run.problem.forced, flight, run.counters);
  if (std::isnan(flight.u)) return give_up_beyond_range(run, run.motion.now);
  const double tau = flight.u * flight.step.length;
  if (tau > remaining || remaining == 0.0) return end_at_time(run, remaining, false, recorders);
  sample(run, tau, false, recorders);
  if (run.progress.over) return;
  move_along(flight, flight.u, clock, run.motion, run.stops);
  run.chatter.since += tau;
  run.hint = {.quiet = !flight.any_near || (run.motion.mode->drift >= 0 && !flight.event)};
  if (!flight.event) return let_dead_coordinates_follow(run.motion, clock.omega);
  handle_instant(run, recorders);
  take_limit(run, recorders);
}

}  // namespace

void advance(Run &run, const Instant &end, Recorders recorders) {
  run.progress = {.begin = run.start ? run.start->instant : run.progress.last.instant,
                  .end = end,
                  .inside_chatter = run.progress.inside_chatter,
                  .next_sample = next_sample(recorders)};
  if (run.start) handle_start(run, recorders);
  take_limit(run, recorders);  // a chatter may stand at a node since the call before
  while (!run.progress.over) {
    run_step(run, recorders);
    const long long steps = run.counters.expansions + run.counters.rest_orders / orders_as_a_step;
    if (!run.progress.over && steps >= run.problem.options.max_steps)
      stop_run(run, Ending::given_up,
               line("more than ", run.problem.options.max_steps,
                    " steps, given up at t = ", time_of(run.motion.now, run.problem.clock),
                    "; the largest rate is ", rate_in_motion(run.motion)));
  }
  // A call that ends at an event has its end state where the run stands.
  if (run.progress.last.displacement.empty())
    set_state(run.motion, run.stops, run.scene(), run.progress.last);
}

}  // namespace vibro_impact::detail
