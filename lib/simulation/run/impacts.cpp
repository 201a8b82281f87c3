#include "impacts.hpp"

#include <algorithm>
#include <cmath>

#include "reports.hpp"
#include "simulation/chain/tolerances.hpp"

namespace vibro_impact::detail {

namespace {

// Counts an impact at a stop, at this closing speed, among those of its chatter. Returns true if
// the mass comes back no slower than it came before, at the same instant of the clock.
bool count_impact(Run &run, StopState &stop, double speed) {
  bool comes_back_at_once = false;
  ++run.counters.impacts;
  if (speed < stop.last_speed) {
    ++stop.falling;
  } else {
    comes_back_at_once = stop.last_speed > 0.0 && stop.since.rounded() == run.motion.now.rounded();
    if (stop.falling >= chatter_impacts) ++run.counters.chatter_incomplete;
    stop.falling = 0;
    stop.since = run.motion.now;
    stop.first_speed = speed;
  }
  stop.last_speed = speed;
  return comes_back_at_once;
}

// To leading order, a mass with the acceleration a towards its stop returns after 2 v / a.
double flight_after(const Motion &motion, const Contact &contact, double speed) {
  const double press = contact.sigma * motion.acceleration[contact.mass];
  return press > 0.0 ? 2.0 * speed / press : infinity;
}

}  // namespace

void gather_hits(Run &run) {
  Scratch &scratch = run.scratch;
  scratch.hits.clear();
  const List<Contact> &contacts = run.motion.mode->contacts;
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    AtStop &at = run.stops[contacts[k].stop].at;
    const Near near = scratch.near[k];
    if (contacts[k].held || near == Near::no || is_idle(at)) continue;
    const bool by_definition = near == Near::zero || near == Near::rest;
    if (!by_definition && !evaluate(run.chain(), contacts[k], run.motion).is_zero()) continue;
    const std::size_t i = contacts[k].mass;
    const Real closing = scaled(run.motion.v[i], contacts[k].sigma);
    if (near == Near::rest || !(std::abs(closing.hi) > zero_threshold * run.motion.v_terms[i]))
      at = Resting{};
    else if (closing.hi > 0.0)
      scratch.hits.push_back({contacts[k], closing});
  }
}

void apply_hits(Run &run, Recorders recorders) {
  const Chain &chain = run.chain();
  Motion &motion = run.motion;
  std::vector<Hit> &hits = run.scratch.hits;
  for (const Hit &hit : hits) {
    const Contact &contact = hit.contact;
    const ImpactLaw &law = contact.law;
    StopState &stop = run.stops[contact.stop];
    const double closing = rounded(hit.closing);
    const bool comes_back_at_once = count_impact(run, stop, closing);
    const Real after = law.after(closing) + Real(law.slope(closing) * hit.closing.lo);
    place(contact.mass, contact.position, scaled(after, -contact.sigma), motion);
    motion.v_terms[contact.mass] = closing;
    // A mass that loses speed has no time to gain it again: the rounding of a force that is zero
    // drives it.
    const bool is_driven_by_rounding = comes_back_at_once && after.hi < closing;
    if (after.hi > 0.0 && !is_driven_by_rounding)
      stop.at = ExactZeros{1, after.hi};
    else
      stop.at = Resting{};
  }
  for (const Hit &hit : hits) {
    const Contact &contact = hit.contact;
    const double closing = rounded(hit.closing);
    report_impact(run, contact.stop, closing, contact.law.after(closing), recorders);
  }
  if (hits.empty()) return;
  find_acceleration(chain, motion);
  for (Hit &hit : hits) {
    const Contact &contact = hit.contact;
    StopState &stop = run.stops[contact.stop];
    const auto *leaving = std::get_if<ExactZeros>(&stop.at);
    if (!leaving) continue;
    hit.flight_time = flight_after(motion, contact, leaving->derivative);
    const double time_left = hit.flight_time / (1.0 - contact.law.at_rest()),
                 passed = rounded(elapsed(stop.since, motion.now, run.chain().clock));
    if (!(time_left < chatter_end * passed)) continue;
    stop.at = Resting{};
    ++run.counters.chatter_limits;
  }
}

}  // namespace vibro_impact::detail
