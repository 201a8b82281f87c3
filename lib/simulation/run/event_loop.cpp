// The event loop chooses a flight, finds the first event in it, moves there and handles the event.
#include <algorithm>
#include <cmath>
#include <limits>

#include "chatter_limit.hpp"
#include "endings.hpp"
#include "events_at_an_instant.hpp"
#include "reports.hpp"
#include "simulation/chain/tolerances.hpp"

namespace vibro_impact::detail {

namespace {

// The longest step of a mode. A mode without a rate, as a free fall, is exact at any length and
// takes steps as long as the time before.
double longest_step_of(const Run &run) {
  const double rate = run.motion.mode->fastest;
  if (rate > 0.0) return std::min(max_step_radians / rate, longest_step);
  return std::clamp(run.time(), max_step_radians / run.chain().rate_bound, longest_step);
}

Step plan_step(Run &run) {
  const double of_mode = longest_step_of(run);
  const double longest = std::clamp(run.hint.step_between_events, shortest_step * of_mode, of_mode);
  run.hint.step_between_events = longest;
  Step step;
  step.length = std::min(
      longest, std::max(expected_flight_margin * run.hint.flight_time, shortest_step * longest));
  // A postponed decision is made two roundings of the clock later, or the least normal number after
  // t = 0. Where a longest step ends before that instant, the decision is postponed again.
  if (std::any_of(run.stops.begin(), run.stops.end(),
                  [](const StopState &stop) { return is<Postponed>(stop.at); })) {
    const double phase = run.motion.now.rounded().phase;
    step.length = std::min(longest, std::max(2.0 * (std::nextafter(phase, infinity) - phase),
                                             std::numeric_limits<double>::min()));
  }
  step.unit = 2.0 * leading_power(step.length);
  step.u_max = step.length / step.unit;
  step.order =
      order_of(run.motion.mode->fastest * step.length, run.problem.options.flight_tolerance);
  int zeros = 0;  // a gap with many zeros needs an order beyond them
  for (const Start &start : run.scratch.starts) zeros = std::max(zeros, start.zeros);
  if (zeros > 1) step.order = std::max(step.order, std::min(max_order, zeros / 2 * 2 + 5));
  ++run.counters.expansions;
  run.counters.coefficients += step.order + 1;
  return step;
}

void set_starts(Run &run) {
  const List<Contact> &contacts = run.motion.mode->contacts;
  run.scratch.starts.resize(contacts.size());
  run.scratch.near.resize(contacts.size());
  find_acceleration(run.chain(), run.motion);
  for (std::size_t k = 0; k < contacts.size(); ++k)
    run.scratch.starts[k] =
        contact_start(run.chain(), contacts[k], run.stops[contacts[k].stop].at, run.motion);
}

// True when a decision is made again: one was postponed, or a motion of the chain has come to a
// mass that no force acted on.
bool is_decision_due(const Run &run) {
  return std::any_of(run.motion.mode->contacts.begin(), run.motion.mode->contacts.end(),
                     [&run](Contact contact) {
                       const AtStop &at = run.stops[contact.stop].at;
                       if (!is<Forceless>(at)) return is<Postponed>(at);
                       contact.held = true;  // the force on the mass at rest
                       const Value force = evaluate(run.chain(), contact, run.motion);
                       return abs(force.value) > zero_threshold * force.terms;
                     });
}

// Handles the events at the motion of the run, and follows the chatter of its impacts.
void handle_events(Run &run, Recorders recorders) {
  const ContactMode *before = run.motion.mode;
  handle_instant(run, recorders);
  follow_chatter(run, before);
}

// Handles the end of a flight of the length tau, to which the run has been moved.
void end_flight(Run &run, double tau, bool event, Recorders recorders) {
  forget_instant(run);
  event = event || is_decision_due(run);
  const long long quiet_steps = event ? 0 : run.hint.quiet_steps + 1;
  const double longest =
      event ? 0.5 * (run.hint.step_between_events + longest_in_flights * tau) : infinity;
  run.hint = {.quiet_steps = quiet_steps, .step_between_events = longest};
  if (!event) return;
  handle_events(run, recorders);
  take_limit(run, recorders);
}

// Searches one step of the Taylor table.
FlightEnd search_step(Run &run) {
  Scratch &scratch = run.scratch;
  set_starts(run);
  const Step step = plan_step(run);
  return scratch.step.find_first_event(run.chain(), run.motion, step, scratch.starts, scratch.near,
                                       run.counters);
}

// Searches a flight in closed form, up to the end of the call and the rounding of an event there.
FlightEnd search_far(Run &run) {
  const Chain &chain = run.chain();
  if (!run.long_flight.is_under_way()) {
    run.long_flight.begin(chain, run.motion);
    // It sees by itself when a mass without force begins to move.
    for (StopState &stop : run.stops) stop.at = ExactZeros{};
  }
  const double to_end = std::max(0.0, rounded(run.time_until(run.progress.end)));
  return run.long_flight.search(chain, (1.0 + step_rounding) * to_end, steps_left(run),
                                run.scratch.near, run.counters);
}

// Moves the run to the end of the flight that was searched.
void move_to(Run &run, const FlightEnd &end) {
  const Chain &chain = run.chain();
  if (run.long_flight.is_under_way()) return run.long_flight.end(chain, end.tau, run.motion);
  if (!end.event && run.hint.quiet_steps == 0) run.long_flight.set_origin(run.motion);
  if (end.tau.hi > 0.0) move_along(chain, run.scratch.step.table, end.tau, run.motion);
}

// One flight of the loop.
void fly_on(Run &run, Recorders recorders) {
  check_motion(run, run.motion);
  if (run.progress.ending) return;
  const bool far = run.long_flight.takes_over(run.chain(), run.hint.quiet_steps);
  const FlightEnd end = far ? search_far(run) : search_step(run);
  check_search(run, end);
  if (run.progress.ending || limit_ends_flight(run, end.tau, recorders)) return;
  const Real remaining = run.time_until(run.progress.end);
  if (remaining < end.tau || remaining.hi <= 0.0) return end_at_time(run, recorders);
  sample(run, end.tau, recorders);
  if (run.progress.ending) return;
  move_to(run, end);
  end_flight(run, end.tau.hi, end.event, recorders);
}

}  // namespace

void advance(Run &run, const Instant &end, Recorders recorders) {
  run.progress = {.end = end, .next_sample = next_sample(recorders)};
  run.counters = run.limit.counters = {};
  if (run.start) {
    put_at_start(run);
    handle_events(run, recorders);
  }
  // A chatter may stand at a node, or before its limit, since the call before.
  take_limit(run, recorders);
  while (!run.progress.ending) {
    fly_on(run, recorders);
    check_steps(run);
  }
  if (run.limit.is_ahead) count_as_at_node(run);
  // A call that ends at an event has its end state where the run stands.
  if (run.progress.last.displacement.empty()) run.progress.last = state_of(run);
}

}  // namespace vibro_impact::detail
