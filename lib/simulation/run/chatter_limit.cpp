#include "chatter_limit.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "endings.hpp"
#include "events_at_an_instant.hpp"
#include "observers.hpp"
#include "simulation/chain/tolerances.hpp"

namespace vibro_impact::detail {

void follow_chatter(Run &run, const ContactMode *mode_before) {
  const Chain &chain = run.chain();
  const Motion &motion = run.motion;
  const std::vector<Hit> &hits = run.scratch.hits;
  Chatter &chatter = run.chatter;
  if (hits.empty() || motion.mode != mode_before) return chatter.end();
  for (const Hit &hit : hits) {
    const auto *leaving = std::get_if<ExactZeros>(&run.stops[hit.contact.stop].at);
    if (!leaving || leaving->zeros > 1) return chatter.end();  // it has come to rest
  }
  run.hint.flight_time = std::ranges::max(hits, {}, &Hit::flight_time).flight_time;
  const Hit &hit = hits.front();
  const Contact &contact = hit.contact;
  const double r = chain.stops[contact.stop].law.at_rest();
  // With r = 1 the impacts have no limit.
  if (hits.size() > 1 || !(r < 1.0 && hit.flight_time < infinity)) return chatter.end();
  // Each jump of the velocity is r times the one before, as is each impulse. Each energy is r^2
  // times the one before.
  const double v = std::abs(motion.v[contact.mass].hi), m = chain.mass[contact.mass],
               jump = (1.0 + r) / (1.0 - r) * v;
  const ImpactShare share{taken_by_impact(chain, contact.stop, rounded(hit.closing), v),
                          {m * jump, 0.5 * m * v * v}};
  chatter.add(contact.stop, contact.mass, hit.flight_time, r, run.problem.clock, motion,
              -contact.sigma * jump, share);
}

namespace {

// The speed with which the mass of the chatter under way has left its stop.
double rebound_speed(const Run &run) {
  return std::abs(run.motion.v[run.chatter.mass()].hi);
}

// Finds the limit of the chatter under way: the motion there, or null when it is not accurate
// enough, or when another contact may come to zero before it.
Motion *find_limit(Run &run) {
  const Chain &chain = run.chain();
  const Chatter &chatter = run.chatter;
  const RunOptions &options = run.problem.options;
  // The closing speed of the next impact may be a little above the latest rebound speed.
  if (!(next_speed_factor * rebound_speed(run) < options.limit_below_speed)) return nullptr;
  const double tolerance = options.chatter_tolerance / error_share;
  const std::optional<double> left = chatter.time_left(tolerance, run.motion.mode->fastest);
  if (!left) return nullptr;
  find_acceleration(chain, run.motion);
  if (!others_stay_out_of_reach(chain, chatter, run.motion, run.stops, *left)) return nullptr;
  Motion &limit = run.scratch.motion;
  limit = run.motion;
  if (!chatter.extrapolate(tolerance, limit)) return nullptr;
  limit.acceleration_known = false;
  pass(*left, run.problem.clock, limit.now);
  set_turn(chain, limit);
  return &limit;
}

// The least speed of the impacts that recorders ask for, of the chatter with this limit.
double slowest_impact(const Run &run, const Instant &limit, Recorders recorders) {
  const double first = run.stops[run.chatter.stop()].first_speed;
  double slowest = infinity;
  for (const Recorder *recorder : recorders)
    slowest = std::min(slowest, recorder->slowest_impact(first, time_of(limit, run.problem.clock)));
  return slowest;
}

// Advances a copy of the run through the impacts before the limit of its chatter, up to an end
// there, or else as far as there are samples, or impacts at `slowest` and faster. A run that ends
// there takes over the end state of the copy, and stays itself at the latest node: the next call
// finds the same limit again. The copy counts its own steps: a run with samples is given up where
// it is without.
void look_inside(Run &run, const Instant &limit, double slowest, Recorders recorders) {
  Run inside = run;
  inside.counters = {};
  const bool ends_inside = run.progress.end < limit;
  advance(inside, ends_inside ? run.progress.end : limit, recorders,
          ends_inside ? Extent::end_in_chatter : Extent::inside_chatter, slowest);
  for (std::size_t k = 0; k < run.stops.size(); ++k) {
    run.stops[k].reported = inside.stops[k].reported;
    run.stops[k].unreported = inside.stops[k].unreported;
  }
  run.past_impacts = std::max(run.past_impacts, inside.progress.impacts);
  run.modes = std::move(inside.modes);  // with the modes that the copy has built
  run.counters.states_computed += inside.counters.states_computed;
  run.counters.modes_built += inside.counters.modes_built;
  run.progress.next_sample = inside.progress.next_sample;
  if (!ends_inside && inside.progress.ending == Ending::reached) return;
  run.progress = std::move(inside.progress);
  run.ended_inside_chatter = true;
}

}  // namespace

void enter_limit(Run &run, Recorders recorders) {
  forget_instant(run);
  StopState &stop = run.stops[run.chatter.stop()];
  stop.at = Resting{};
  stop.unreported = run.chatter.left();
  stop.unreported -= std::exchange(stop.reported, {});
  run.past_impacts = 0;
  run.chatter.end();
  run.hint = {};
  ++run.counters.chatter_limits;
  run.scratch.hits.clear();
  run.scratch.near.assign(run.motion.mode->contacts.size(), Near::no);
  hold_or_release(run, recorders);
}

void take_limit(Run &run, Recorders recorders) {
  if (run.progress.over || run.progress.extent != Extent::whole || run.hint.quiet_steps > 0 ||
      !run.chatter.is_at_node())
    return;
  Motion *at_limit = find_limit(run);
  if (!at_limit) return;
  const Instant limit = at_limit->now.rounded();
  const double slowest = slowest_impact(run, limit, recorders);
  if (run.progress.end < limit || run.progress.next_sample <= time_of(limit, run.problem.clock) ||
      next_speed_factor * rebound_speed(run) >= slowest) {
    look_inside(run, limit, slowest, recorders);
    if (run.progress.over) return;
  }
  std::swap(run.motion, *at_limit);
  enter_limit(run, recorders);
}

void note_listed_impacts(Run &run) {
  if (run.progress.extent != Extent::inside_chatter || run.scratch.hits.empty()) return;
  run.progress.lists = std::ranges::any_of(run.scratch.hits, [&run](const Hit &hit) {
    return rounded(hit.closing) >= run.progress.slowest;
  });
  end_if_all_is_reported(run);
}

void end_if_all_is_reported(Run &run) {
  const Progress &progress = run.progress;
  if (progress.extent == Extent::inside_chatter && !progress.lists &&
      progress.next_sample > time_of(progress.end, run.problem.clock))
    stop_run(run, Ending::reached);
}

}  // namespace vibro_impact::detail
