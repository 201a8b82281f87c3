// The loop over the steps of the pipeline, for lanes of one size: fixed, or any.
#pragma once

#include "instant_events.hpp"
#include "run_state.hpp"

namespace vibro_impact {

template <int D>
void give_up_beyond_range(Run<D> &run, const State<D> &state) {
  if (!std::isfinite(state.value.sum() + state.slope.sum()))
    give_up(run, line("the motion leaves the range of double precision before t = ",
                      time_of(state.now, run.clock), ", given up"));
}

// The end of the run, in a motion that nothing can happen to: in closed form.
template <int D>
void end_undisturbed(Run<D> &run, double remaining) {
  run.flight.path = {.span = remaining};
  sample_flight(run, remaining);
  if (run.over) return;
  run.at_end = run.state;
  move_lanes(run.at_end, run.scene, run.clock, run.flight.path, remaining);
  read_gaps(run.at_end);
  run.at_end.now = run.end;
  ++run.counters.modal_evaluations;
  run.over = true;
  give_up_beyond_range(run, run.at_end);
}

// The span of the next expansion, unless the run has to be given up.
template <int D>
double choose_span(Run<D> &run, double rate) {
  const State<D> &state = run.state;
  // The longest up to `max_reach` that is added to the phase without rounding. The motion of a long
  // flight would run ahead of its time by the rounding of every step, the same one for hundreds.
  const double phase = state.now.phase, most = max_reach / rate, end = phase + most,
               longest = end - phase <= most ? end - phase : std::nextafter(end, phase) - phase;
  give_up_beyond_range(run, state);
  if (longest == 0.0 && !run.over)
    give_up(run, line("the rate ", rate, " of the fastest mode cannot be resolved at t = ",
                      time_of(state.now, run.clock), ", given up"));
  // Flights may be short without bound (r = 1e-300), spans not: slope * span must not underflow.
  return std::min(longest, std::max(state.span_expected, lost * longest));
}

// Runs on to the end, or until a recorder is done or the run has to be given up. The state it
// leaves is that of the last step before, from which the motion goes on to `at_end`: the steps do
// not depend on where a run ends.
template <int D>
void run_on(Run<D> &run) {
  State<D> &state = run.state;
  while (!run.over) {
    const double remaining = std::max(0.0, elapsed(state.now, run.end, run.clock));
    if (state.clear && (state.mode->contacts.empty() || stays_clear_for_ever(state, run.scene)))
      return end_undisturbed(run, remaining);
    const double rate = fastest_in_motion(state), span = choose_span(run, rate);
    if (run.over) break;
    Flight<D> &flight = run.flight;
    expand(rate, span, run.options.flight_tolerance, flight.path, run.counters);
    find_first_event(state, run.scene_rate, flight, run.counters);
    const double tau = flight.u * span;
    if (tau > remaining || remaining == 0.0) {
      sample_flight(run, remaining);
      if (run.over) return;
      run.at_end = state;
      move_along(run.at_end, flight, remaining / span, run.scene, run.clock);
      run.at_end.now = run.end;
      run.over = true;
      return;
    }
    sample_flight(run, tau);
    if (run.over) return;
    move_along(state, flight, flight.u, run.scene, run.clock);
    state.span_expected = std::numeric_limits<double>::infinity();
    run.chatter.impacts.since += tau;
    state.clear = flight.all_clear;
    if (flight.eventful) handle_instant(run);
    if (run.over) break;
    // One that takes neither events nor samples is asked after every flight.
    for (const RecorderRef &ref : run.recorders)
      if (!ref.event && !ref.sample) ask_whether_done(run, ref);
  }
  // Unless that is a sample, a run that ends early ends where it is.
  if (run.at_end.mode == nullptr) run.at_end = state;
}

template <int D>
void look_inside(Run<D> &run, const Instant &then) {
  run.before = run.state;
  run.chatter_before = run.chatter;
  const Instant end = run.end;
  Counters counters = run.counters;
  run.end = std::min(end, then);
  run.silent = true;
  run_on(run);
  run.silent = false;
  run.over = end < then || run.ending != Ending::reached;
  run.end = end;
  if (!run.over) run.at_end.mode = nullptr;
  std::swap(run.state, run.before);
  std::swap(run.chatter, run.chatter_before);
  counters.modal_evaluations = run.counters.modal_evaluations;
  counters.modes_built = run.counters.modes_built;
  run.counters = counters;
}

// From a motion: nothing is known of the stops but the gaps. Masses that move into their stop have
// their impact at this instant, and belong to it.
template <int D>
void start_from(Run<D> &run, const MotionState &motion) {
  State<D> &state = run.state;
  run.motion = motion;
  state.now = state.window_start = motion.instant;
  set_lanes(state, run.scene, run.modes.enter(run.scene, motion.held, run.counters), motion);
  state.stops.resize(run.scene.stops.size());
  for (std::size_t k = 0; k < state.stops.size(); ++k) {
    const Stop &stop = run.scene.stops[k];
    const auto i = static_cast<std::size_t>(stop.mass - 1);
    set_in_flight(state.stops[k], sign(stop.side) * (stop.position - motion.displacement[i]),
                  -sign(stop.side) * motion.velocity[i]);
  }
  const ContactMode<D> *mode = state.mode;
  for (std::size_t k = 0; k < mode->contacts.size(); ++k) {
    const AtStop &at = state.stops[mode->contacts[k].stop];
    if (!mode->contacts[k].held && at.gap == 0.0 && at.speed < 0.0) run.hits.push_back(k);
  }
  apply_impacts(run);
  for (const std::size_t k : run.hits)
    run.motion.velocity[mode->contacts[k].mass] =
        -mode->contacts[k].sigma * state.stops[mode->contacts[k].stop].speed;
  hold_or_release(run, true);
  follow_chatter(run, mode);
}

// From where another run stood, which may have come to a node of a chatter just then.
template <int D>
void start_from(Run<D> &run, const RunState &from) {
  Row row{.numbers = from.numbers, .reads = true};
  pass(row, run);
  if (!run.chatter.under_way()) return;
  const auto nodes = std::exchange(run.chatter.table.nodes, {});
  begin(run.chatter, *run.state.mode, run.chatter.impacts.contacts);
  for (const ChatterTable::Node &node : nodes) extend(run.chatter.table, node);
  take_limit(run);
}

template <int D>
Outcome run_lanes(const Scene &scene, const MotionState *motion, const RunState *state,
                  double until, const RunOptions &options, std::span<const RecorderRef> recorders) {
  Run<D> run{scene, options, recorders};
  run.end = instant_at(until, run.clock);
  if (motion != nullptr)
    start_from(run, *motion);
  else
    start_from(run, *state);
  run_on(run);
  set_motion(run.at_end, scene, run.motion);
  Row row;
  pass(row, run);
  return {run.motion,   time_of(run.motion.instant, run.clock),
          run.ending,   run.reason,
          run.counters, RunState{row.numbers}};
}

}  // namespace vibro_impact
