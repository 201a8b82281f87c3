#include "vibro_impact/analysis/orbit_record.hpp"

#include <algorithm>
#include <cmath>
#include <regex>
#include <set>
#include <stdexcept>
#include <utility>

#include "analysis/orbits/orbit_tolerances.hpp"
#include "settled.hpp"
#include "vibro_impact/analysis/periodic_orbit.hpp"

namespace vibro_impact {

namespace {

Smooth<Growth> exponent_of(const Scene &scene, const Settled &settled,
                           const RecordOptions &options) {
  const Smooth<Multipliers> &multipliers = settled.motion.orbit.multipliers;
  if (settled.motion.period == 0) {
    const RunOptions &run = options.settle.run;
    return mean_growth(scene, at_quiet_phase(scene, settled.motion.state, run), options.growth,
                       run);
  }
  if (!multipliers.exists()) return Smooth<Growth>::none(multipliers.why_not());
  const double modulus = largest_modulus(*multipliers),
               time = settled.motion.period * Clock(scene.omega).period;
  return Growth{std::log(modulus) / time, modulus > 0.0 ? exponent_error / time : 0.0};
}

// Each kind of pair once, in the order of Table I. Every sticking phase is whole in two periods.
std::vector<EventPair> kinds_of_pairs(const Motion &motion) {
  const Motion twice = motion_of(motion.scene, motion.start(), 2 * motion.periods, motion.options);
  std::set<EventPair> kinds;
  for (const PairedEvents &pair : pairs_of(twice)) kinds.insert(pair.kind);
  return {kinds.begin(), kinds.end()};
}

}  // namespace

OrbitRecord record_of(const Scene &scene, const RecordOptions &options) {
  return record_of(scene, start_of(scene), options);
}

OrbitRecord record_of(const Scene &scene, const MotionState &start, const RecordOptions &options) {
  const double slowest = options.slowest.value_or(0.0);
  require(slowest >= 0.0, "slowest = ", slowest, ": must be non-negative");
  check_settling(scene, start, options.settle);
  const Settled found = settled(scene, start, options.settle);
  const bool has_settled = found.motion.period > 0;
  OrbitRecord record;
  record.period = found.motion.period;
  record.approached = found.motion.approached;
  record.state = found.motion.state;
  RunOptions run = options.settle.run;
  const MotionState first = has_settled ? found.orbit.motion.start() : record.state;
  const int periods = has_settled ? record.period : periods_counted;
  const Samples sections{.phase = start.instant.phase};
  Motion motion =
      has_settled ? found.orbit.motion : motion_of(scene, first, periods, run, sections);
  record.counts =
      has_settled ? found.motion.counts : counts_of(scene, events_of(motion), periods, first.held);
  record.size = has_settled ? found.orbit.size : 0.0;
  if (options.section || (options.attractor && has_settled))
    for (const MotionState &state : has_settled ? found.motion.section : samples_of(motion))
      record.section.push_back(coordinates(state));
  if (options.pairs) record.pairs = kinds_of_pairs(motion);
  if (options.impacts) {
    run.limit_below_speed = std::min(
        run.limit_below_speed, options.slowest.value_or(slow_impact * fastest_impact(motion)));
    motion = motion_of(scene, first, periods, run);
    record.impacts.resize(scene.mass.size());
    for (const Event &event : events_of(motion))
      if (event.kind == EventKind::impact) record.impacts[index_of(event.mass)].push_back(event);
    const Instant section{first.instant.phase <= start.instant.phase ? 0 : 1, start.instant.phase};
    for (std::vector<Event> &of_mass : record.impacts) {
      const auto first_after = std::ranges::find_if(
          of_mass, [&section](const Event &event) { return !(event.instant < section); });
      std::rotate(of_mass.begin(), first_after, of_mass.end());
    }
  }
  if (options.lyapunov) record.lyapunov = exponent_of(scene, found, options);
  if (options.response) record.response = response_of(scene, first, periods, options.settle.run);
  return record;
}

bool same_attractor(const Scene &scene, const OrbitRecord &one, const OrbitRecord &other) {
  check(scene);
  const std::size_t coordinates = 2 * scene.mass.size();
  for (const OrbitRecord *record : {&one, &other})
    for (const std::vector<double> &state : record->section)
      require(state.size() == coordinates, "section: a state of ", state.size(),
              " coordinates, the chain has ", coordinates);
  if (one.period == 0 || one.period != other.period) return false;
  const Eigen::VectorXd units = length_units(scene);
  const double error = same_orbit * std::max(one.size, other.size);
  return !one.section.empty() &&
         std::ranges::any_of(other.section, [&](const std::vector<double> &state) {
           const Eigen::VectorXd apart = view(one.section.front()) - view(state);
           return apart.cwiseQuotient(units).stableNorm() <= error;
         });
}

PointRecord point_record(const Scene &scene, const RecordOptions &options,
                         const std::optional<OrbitRecord> &before) {
  try {
    if (!before) return {record_of(scene, options), {}};
    const Scene inside = with_start_inside(scene);
    return {record_of(inside, start_near(inside, before->state), options), {}};
  } catch (const std::invalid_argument &refused) {
    return {{}, refused.what(), true};
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
