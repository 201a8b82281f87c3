#include "vibro_impact/analysis/orbit_record.hpp"

#include <algorithm>

#include "simulation/for_analysis.hpp"
#include "vibro_impact/analysis/lyapunov.hpp"
#include "vibro_impact/analysis/periodic_orbit.hpp"

namespace vibro_impact {

namespace {

// The motion goes on from where it settled for as many periods as are recorded.
void record_on(const Scene &scene, const SettledMotion &motion, int periods,
               const RecordOptions &options, OrbitRecord &record) {
  const Instant from = motion.state.instant;
  const double begin = time_of(from, Clock(scene.omega)),
               until = time_after(scene, motion.state, periods);
  RunOptions run = options.settle.run;
  EventMarks marks{from};
  std::vector<ImpactSpeedRecorder> speeds;
  std::vector<RecorderRef> recorders{recorder_ref(marks)};
  if (options.impact_velocities) {
    run.resolve_chatter = std::min(run.resolve_chatter, options.slowest);
    for (int mass = 1; mass <= scene.masses(); ++mass) speeds.push_back({mass, begin});
    for (ImpactSpeedRecorder &speed : speeds) recorders.push_back(recorder_ref(speed));
  }
  require_complete(resume_seen(scene, motion.resume, until, run, recorders));
  record.work.recorded += periods;
  record.counts = counts_of(scene, marks.marks, periods, dual_sticking(motion.state.held));
  for (ImpactSpeedRecorder &speed : speeds)
    record.impact_velocities.push_back(std::move(speed.velocities));
}

double exponent_of(const Scene &scene, const OrbitRecord &record, const RecordOptions &options,
                   RecordWork &work) {
  const RunOptions &run = options.settle.run;
  const MotionState start = at_quiet_phase(scene, record.state, run);
  work.with_tangents += record.period > 0 ? record.period : options.counted;
  if (record.period > 0) {
    const StroboscopicImage image =
        stroboscopic_map_and_derivative(scene, start, record.period, run);
    return greatest_exponent(floquet_multipliers(image.derivative, start.held),
                             record.period * Clock(scene.omega).period);
  }
  GrowthRecorder growth(scene, start);
  const double until = time_after(scene, start, options.counted);
  growth.finish(require_complete(simulate_from(scene, start, until, run, growth)).state.instant);
  return growth.exponent();
}

std::vector<EventPair> pairs_of(const Scene &scene, const OrbitRecord &record,
                                const RecordOptions &options, RecordWork &work) {
  const int periods = 2 * (record.period > 0 ? record.period : options.counted);
  work.recorded += periods;
  PressedEventRecorder recorder{scene};
  stroboscopic_map(scene, record.state, periods, options.settle.run, recorder);
  const std::vector<PairedEvents> pairs = event_pairs(recorder.events);
  std::vector<EventPair> found;
  for (const EventPair kind : all_event_pairs)
    if (std::any_of(pairs.begin(), pairs.end(), [kind](auto &pair) { return pair.kind == kind; }))
      found.push_back(kind);
  return found;
}

}  // namespace

OrbitRecord record_of(const Scene &scene, const MotionState &start, const RecordOptions &options) {
  require(options.counted >= 1, "counted = ", options.counted, ": must be at least 1");
  require(options.slowest >= 0.0, "slowest = ", options.slowest, ": must be non-negative");
  SettledMotion motion = settle(scene, start, options.settle);
  OrbitRecord record;
  record.period = motion.period;
  record.to_come = motion.to_come;
  record.counters = motion.counters;
  record.work.settling = motion.periods_run;
  if (motion.period == 0 || options.impact_velocities)
    record_on(scene, motion, motion.period > 0 ? motion.period : options.counted, options, record);
  else
    record.counts = std::move(motion.counts);
  record.state = std::move(motion.state);
  record.state.instant.cycle = 0;
  if (options.lyapunov) record.lyapunov = exponent_of(scene, record, options, record.work);
  if (options.pairs) record.pairs = pairs_of(scene, record, options, record.work);
  return record;
}

OrbitRecord record_of(const Scene &scene, const RecordOptions &options) {
  check(scene);
  return record_of(scene, start_of(scene), options);
}

}  // namespace vibro_impact
