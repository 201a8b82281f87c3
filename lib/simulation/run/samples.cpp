#include "samples.hpp"

#include "endings.hpp"
#include "observers.hpp"
#include "simulation/chain/require.hpp"

namespace vibro_impact::detail {

namespace {

// The time, as it is reported, of the instant `tau` after the motion of the run.
double time_after(const Run &run, const Real &tau) {
  TwofoldInstant then = run.motion.now;
  pass(tau, run.chain().clock, then);
  return time_of(then.rounded(), run.chain().clock);
}

// Reports the samples up to the time `last`, with the motion no later than `tau`.
void sample_up_to(Run &run, double last, const Real &tau, Recorders recorders) {
  while (run.progress.next_sample <= last) {
    const double next = run.progress.next_sample;
    require(next >= run.time(), "next_time = ", next,
            ": lies before the motion, which is at t = ", run.time());
    const Instant at = instant_at(next, run.chain().clock);
    Real since = time_until(run, at);
    if (tau < since) since = tau;
    ++run.counters.states_computed;
    const MomentOfMotion moment(run, motion_at(run, since), at);
    if (!report_sample(run, moment, next, recorders)) continue;
    run.progress.last = moment.state();
    return stop_run(run, Ending::stopped);
  }
}

}  // namespace

Real time_until(const Run &run, const Instant &instant) {
  return elapsed(run.motion.now, TwofoldInstant(instant), run.chain().clock);
}

void sample(Run &run, const Real &tau, Recorders recorders) {
  if (run.progress.next_sample < infinity) sample_up_to(run, time_after(run, tau), tau, recorders);
}

void end_at_time(Run &run, Recorders recorders) {
  const Real tau = time_until(run, run.progress.end);
  sample_up_to(run, run.progress.until, tau, recorders);
  if (run.progress.over) return;
  const Motion &motion = motion_at(run, tau);
  run.progress.last = MomentOfMotion(run, motion, run.progress.end).state();
  if (run.long_flight.is_under_way()) ++run.counters.states_computed;
  check_motion(run, motion);
  stop_run(run, Ending::reached);
}

}  // namespace vibro_impact::detail
