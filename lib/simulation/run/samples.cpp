#include "samples.hpp"

#include "endings.hpp"
#include "observers.hpp"
#include "simulation/chain/require.hpp"

namespace vibro_impact::detail {

Real time_until(const Run &run, const Instant &instant) {
  return elapsed(run.motion.now, TwofoldInstant(instant), run.chain().clock);
}

void sample(Run &run, const Real &tau, Recorders recorders) {
  while (run.progress.next_sample < infinity) {
    const double next = run.progress.next_sample;
    const Instant at = instant_at(next, run.chain().clock);
    const Real since = time_until(run, at);
    if (!(since <= tau) && since.hi > 0.0) return;
    require(since.hi >= 0.0 || next >= run.time(), "next_time = ", next,
            ": lies before the motion, which is at t = ", run.time());
    ++run.counters.states_computed;
    const MomentOfMotion moment(run, motion_at(run, since), at);
    if (!report_sample(run, moment, next, recorders)) continue;
    run.progress.last = moment.state();
    return stop_run(run, Ending::stopped);
  }
}

void end_at_time(Run &run, Recorders recorders) {
  const Real tau = time_until(run, run.progress.end);
  sample(run, tau, recorders);
  if (run.progress.over) return;
  const Motion &motion = motion_at(run, tau);
  run.progress.last = MomentOfMotion(run, motion, run.progress.end).state();
  if (run.long_flight.is_under_way()) ++run.counters.states_computed;
  check_motion(run, motion);
  stop_run(run, Ending::reached);
}

}  // namespace vibro_impact::detail
