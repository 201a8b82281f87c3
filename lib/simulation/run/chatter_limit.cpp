#include "chatter_limit.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>
#include <utility>

#include "events_at_an_instant.hpp"
#include "reports.hpp"
#include "simulation/chain/tolerances.hpp"

namespace vibro_impact::detail {

void follow_chatter(Run &run, const ContactMode *mode_before) {
  const std::vector<Hit> &hits = run.scratch.hits;
  Chatter &chatter = run.chatter;
  if (hits.empty() || run.motion.mode != mode_before) return chatter.end();
  for (const Hit &hit : hits) {
    const auto *leaving = std::get_if<ExactZeros>(&run.stops[hit.contact.stop].at);
    if (!leaving || leaving->zeros > 1) return chatter.end();  // it has come to rest
  }
  run.hint.flight_time = std::ranges::max(hits, {}, &Hit::flight_time).flight_time;
  const Hit &hit = hits.front();
  const double r = hit.contact.law.at_rest();
  // With r = 1 the impacts have no limit.
  if (hits.size() > 1 || !(r < 1.0 && hit.flight_time < infinity)) return chatter.end();
  chatter.add(run.chain(), run.motion, hit.contact, rounded(hit.closing), hit.flight_time);
}

namespace {

// The speed with which the mass of the chatter under way has left its stop.
double rebound_speed(const Run &run) {
  return std::abs(run.motion.v[run.chatter.contact().mass].hi);
}

// Finds the limit of the chatter under way. Returns false when it is not accurate enough, or when
// another contact may come to zero before it.
bool find_limit(Run &run) {
  const Chain &chain = run.chain();
  const Chatter &chatter = run.chatter;
  const RunOptions &options = run.problem.options;
  // The closing speed of the next impact may be a little above the latest rebound speed.
  if (!(next_speed_factor * rebound_speed(run) < options.limit_below_speed)) return false;
  const double tolerance = options.chatter_tolerance / error_share;
  const std::optional<double> left = chatter.time_left(tolerance, run.motion.mode->fastest);
  if (!left) return false;
  find_acceleration(chain, run.motion);
  if (!others_stay_out_of_reach(chain, chatter, run.motion, run.stops, *left)) return false;
  Motion &motion = run.limit.motion;
  motion = run.motion;
  if (!chatter.extrapolate(tolerance, motion)) return false;
  motion.acceleration_known = false;
  pass(*left, chain.clock, motion.now);
  set_turn(chain, motion);
  run.limit.stop = chatter.contact().stop;
  run.limit.stops = run.stops;
  run.limit.unreported = chatter.sum_left();
  return true;
}

// True if the end of the call, a sample or an impact that recorders ask for lies before the limit.
// As a call begins within a flight, the next impact is not known.
bool is_any_left(Run &run, Recorders recorders) {
  ChatterLimit &limit = run.limit;
  const Instant instant = limit.motion.now.rounded();
  const double time = time_of(instant, run.chain().clock);
  limit.slowest = infinity;
  for (const Recorder *recorder : recorders)
    limit.slowest = std::min(limit.slowest,
                             recorder->slowest_impact(limit.stops[limit.stop].first_speed, time));
  return run.progress.end < instant || run.progress.next_sample <= time ||
         run.hint.quiet_steps > 0 || next_speed_factor * rebound_speed(run) >= limit.slowest;
}

}  // namespace

void enter_limit(Run &run, Recorders recorders) {
  ChatterLimit &limit = run.limit;
  std::swap(run.motion, limit.motion);
  std::swap(run.stops, limit.stops);
  if (std::exchange(limit.is_ahead, false)) count_as_at_node(run);
  forget_instant(run);
  StopState &stop = run.stops[limit.stop];
  stop.at = Resting{};
  // The sums without the impacts that were reported may be negative by rounding.
  stop.unreported = {std::max(0.0, limit.unreported.impulse),
                     std::max(0.0, limit.unreported.energy)};
  run.chatter.end();
  run.hint = {};
  ++run.counters.chatter_limits;
  run.scratch.hits.clear();
  run.scratch.near.assign(run.motion.mode->contacts.size(), Near::no);
  hold_or_release(run, recorders);
}

void take_limit(Run &run, Recorders recorders) {
  ChatterLimit &limit = run.limit;
  if (run.progress.ending) return;
  if (!limit.is_ahead &&
      (run.hint.quiet_steps > 0 || !run.chatter.is_at_node() || !find_limit(run)))
    return;
  if (!is_any_left(run, recorders)) return enter_limit(run, recorders);
  if (!std::exchange(limit.is_ahead, true)) limit.counters = std::exchange(run.counters, {});
}

bool limit_ends_flight(Run &run, const Real &tau, Recorders recorders) {
  if (!run.limit.is_ahead || run.progress.end < run.limit.motion.now.rounded()) return false;
  assert(!run.long_flight.is_under_way());  // the limit is less than half a radian away
  const Real left = elapsed(run.motion.now, run.limit.motion.now, run.chain().clock);
  if (tau < left) return false;
  sample(run, left, recorders);
  if (!run.progress.ending) enter_limit(run, recorders);
  return true;
}

void count_as_at_node(Run &run) {
  Counters &at_node = run.limit.counters;
  at_node.states_computed += run.counters.states_computed;
  at_node.modes_built += run.counters.modes_built;
  run.counters = at_node;
}

}  // namespace vibro_impact::detail
