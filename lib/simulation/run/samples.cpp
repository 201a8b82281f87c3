#include "samples.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "events_at_an_instant.hpp"
#include "observers.hpp"
#include "simulation/chain/require.hpp"
#include "simulation/flight/quiet_flight.hpp"

namespace vibro_impact::detail {

namespace {

// Sets scratch.sampled to the motion at `instant`, `tau` after the motion of the run: along the
// step in scratch.flight, or in closed form on a flight without events.
void set_sampled(Run &run, const Instant &instant, double tau, bool in_closed_form) {
  Scratch &scratch = run.scratch;
  const Clock &clock = run.problem.clock;
  scratch.sampled = run.motion;
  scratch.sampled_stops = run.stops;
  if (in_closed_form) {
    fly(scratch.sampled, clock, instant);
    forget_instant(scratch.sampled_stops);
  } else {
    move_along(scratch.flight, tau / scratch.flight.step.length, clock, scratch.sampled,
               scratch.sampled_stops);
  }
}

// Makes the sampled motion at `instant` the state at the end of the call.
void set_last(Run &run, const Instant &instant) {
  set_state(run.scratch.sampled, run.scratch.sampled_stops, run.scene(), run.progress.last);
  run.progress.last.instant = instant;
}

}  // namespace

void sample(Run &run, double tau, bool in_closed_form, Recorders recorders) {
  const Clock &clock = run.problem.clock;
  while (run.progress.next_sample < infinity) {
    const double next = run.progress.next_sample;
    const Instant instant = instant_at(next, clock);
    const double since = time_until(run.motion, instant, clock);
    if (std::max(0.0, since) > tau) return;
    require(since >= -16.0 * std::numeric_limits<double>::epsilon() * next, "next_time = ", next,
            ": lies before the motion, which is at t = ", time_of(run.motion.now, clock));
    set_sampled(run, instant, std::max(0.0, since), in_closed_form);
    ++run.counters.modal_evaluations;
    if (!report_sample(run, next, recorders)) continue;
    set_last(run, instant);
    return stop_run(run, Ending::stopped);
  }
}

void end_at_time(Run &run, double tau, bool in_closed_form, Recorders recorders) {
  sample(run, tau, in_closed_form, recorders);
  if (run.progress.over) return;
  set_sampled(run, run.progress.end, tau, in_closed_form);
  if (in_closed_form) ++run.counters.modal_evaluations;
  set_last(run, run.progress.end);
  for (const double x : run.progress.last.displacement)
    if (!std::isfinite(x)) give_up_beyond_range(run, run.progress.end);
  stop_run(run, Ending::reached);
}

void look_inside(Run &run, const Instant &limit, Recorders recorders) {
  Run inside = run;
  inside.counters = {};
  inside.progress.inside_chatter = true;
  advance(inside, std::min(run.progress.end, limit), recorders);
  run.modes = std::move(inside.modes);  // with the modes that the copy has built
  run.counters.modal_evaluations += inside.counters.modal_evaluations;
  run.counters.modes_built += inside.counters.modes_built;
  run.progress.next_sample = inside.progress.next_sample;
  if (run.progress.end < limit || inside.progress.ending != Ending::reached) {
    run.progress = std::move(inside.progress);
    run.progress.inside_chatter = false;
  }
}

void give_up_beyond_range(Run &run, const Instant &instant) {
  stop_run(run, Ending::given_up,
           line("the motion leaves the range of double precision before t = ",
                time_of(instant, run.problem.clock), ", given up"));
}

}  // namespace vibro_impact::detail
