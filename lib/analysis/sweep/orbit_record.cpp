#include "vibro_impact/analysis/orbit_record.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <regex>
#include <set>
#include <stdexcept>
#include <utility>

#include "analysis/orbits/motion_state.hpp"
#include "analysis/orbits/orbit_tolerances.hpp"
#include "vibro_impact/analysis/periodic_orbit.hpp"

namespace vibro_impact {

namespace {

// Follows the motion from where it settled for `periods` forcing periods, and records them.
void record_on(const Scene &scene, const SettledMotion &motion, int periods,
               const RecordOptions &options, OrbitRecord &record) {
  RunOptions run = options.settle.run;
  if (options.impacts)
    run.limit_below_speed = std::min(run.limit_below_speed,
                                     options.slowest.value_or(slow_impact * motion.fastest_impact));
  Simulation simulation = motion.simulation;
  simulation.set_options(run);
  EventRecorder events(-infinity);
  MotionState state = motion.state;
  for (int k = 1; k <= periods; ++k) {
    if (options.section) record.section.push_back(coordinates(state));
    state = require_complete(simulation.advance(time_after(scene, motion.state, k), events)).state;
  }
  record.counts = counts_of(scene, events.events, periods, motion.state.held);
  if (!options.impacts) return;
  record.impacts.resize(scene.mass.size());
  for (const Event &event : events.events)
    if (event.kind == EventKind::impact)
      record.impacts[static_cast<std::size_t>(event.mass - 1)].push_back(event);
}

Growth exponent_of(const Scene &scene, const OrbitRecord &record, const RecordOptions &options) {
  const RunOptions &run = options.settle.run;
  const MotionState start = at_quiet_phase(scene, record.state, run);
  if (record.period == 0) return mean_growth(scene, start, options.growth, run);
  const StroboscopicImage image = stroboscopic_map_and_derivative(scene, start, record.period, run);
  const auto multipliers = floquet_multipliers(image.derivative, start.held);
  const double modulus = multipliers.empty() ? 0.0 : std::abs(multipliers.front()),
               time = record.period * Clock(scene.omega).period;
  return {std::log(modulus) / time, modulus > 0.0 ? exponent_error / time : 0.0};
}

// Each kind of pair once, in the order of Table I.
std::vector<EventPair> pairs_of(const Scene &scene, const OrbitRecord &record,
                                const RunOptions &run) {
  const int periods = 2 * (record.period > 0 ? record.period : periods_counted);
  PressedEventRecorder recorder(scene);
  stroboscopic_map(scene, record.state, periods, run, recorder);
  std::set<EventPair> kinds;
  for (const PairedEvents &pair : event_pairs(recorder.events)) kinds.insert(pair.kind);
  return {kinds.begin(), kinds.end()};
}

}  // namespace

OrbitRecord record_of(const Scene &scene, const RecordOptions &options) {
  return record_of(scene, start_of(scene), options);
}

OrbitRecord record_of(const Scene &scene, const MotionState &start, const RecordOptions &options) {
  const double slowest = options.slowest.value_or(0.0);
  require(slowest >= 0.0, "slowest = ", slowest, ": must be non-negative");
  SettledMotion motion = settle(scene, start, options.settle);
  OrbitRecord record;
  record.period = motion.period;
  record.approached = motion.approached;
  if (options.attractor && motion.period > 0)
    record.attractor = attractor_mark(scene, motion.section);
  if (motion.period == 0 || options.impacts || options.section)
    record_on(scene, motion, motion.period > 0 ? motion.period : periods_counted, options, record);
  else
    record.counts = std::move(motion.counts);
  record.state = std::move(motion.state);
  record.state.instant.cycle = 0;
  if (options.lyapunov) record.lyapunov = exponent_of(scene, record, options);
  if (options.pairs) record.pairs = pairs_of(scene, record, options.settle.run);
  return record;
}

double attractor_mark(const Scene &scene, const std::vector<MotionState> &section) {
  check(scene);
  const std::vector<double> frequency = local_frequencies(scene);
  double sum = 0.0, largest = 0.0;
  for (const MotionState &state : section) {
    require_fits(scene, state);
    for (std::size_t i = 0; i < frequency.size(); ++i) {
      const double weight = 1.0 + std::fmod(std::numbers::phi * static_cast<double>(i + 1), 1.0),
                   x = weight * state.displacement[i],
                   v = weight * std::numbers::sqrt2 / 2.0 * state.velocity[i] / frequency[i];
      sum += x + v;
      largest = std::max({largest, std::abs(x), std::abs(v)});
    }
  }
  if (largest == 0.0) return 0.0;
  const double unit = mark_error * std::ldexp(1.0, std::ilogb(largest));
  return unit * std::round(sum / static_cast<double>(section.size()) / unit);
}

PointRecord point_record(const Scene &scene, const RecordOptions &options,
                         const std::optional<OrbitRecord> &before) {
  try {
    if (!before) return {record_of(scene, options), {}};
    return {record_of(scene, start_near(scene, before->state), options), {}};
  } catch (const std::invalid_argument &refused) {
    return {{}, refused.what()};
  } catch (const std::runtime_error &given_up) {
    return {{}, given_up.what()};
  }
}

std::string kind_of_reason(const std::string &reason) {
  static const std::regex number("[-+]?[0-9]+(\\.[0-9]+)?(e[-+]?[0-9]+)?");
  return std::regex_replace(reason, number, "#");
}

MotionState start_near(const Scene &scene, MotionState state) {
  check(scene);
  state = moved_into(scene, std::move(state));
  move_inside(scene, state.displacement);
  check(scene, state);
  return state;
}

}  // namespace vibro_impact
