#include "events_at_an_instant.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "impacts.hpp"
#include "reports.hpp"
#include "simulation/chain/tolerances.hpp"

namespace vibro_impact::detail {

namespace {

// Puts a mass into question.
void add_resting(Run &run, const Contact &contact, int known_zeros) {
  for (const RestingMass &mass : run.scratch.resting)
    if (mass.contact.mass == contact.mass) return;
  run.scratch.resting.push_back({.contact = contact, .known_zeros = known_zeros});
}

// The number of orders of the force on a held mass that count as exactly zero at this instant:
//
//   2  the force touches zero, with its slope
//   1  it is at its root, or zero but for rounding: next to a root, or with an impact whose jump a
//      damper passes on
//   0  it has jumped elsewhere, or was never near zero
int known_zeros_of(const Run &run, std::size_t k, const Value &force) {
  const Near near = run.scratch.near[k];
  if (near == Near::no) return 0;
  if (near == Near::perhaps || !run.scratch.hits.empty()) return force.is_zero() ? 1 : 0;
  return near == Near::touch ? 2 : 1;
}

// The motion of the chain and of the forcing, within a window of time, has a rounding. A mass whose
// bounces have died down below it is at rest with the others in question.
void question_dead_bounces(Run &run) {
  const Chain &chain = run.chain();
  const Motion &motion = run.motion;
  double speed = 0.0;
  for (std::size_t i = 0; i < chain.masses; ++i) speed = std::max(speed, std::abs(motion.v[i].hi));
  const double window = time_window(chain, run.time()),
               rounding = twofold_unit * (speed + chain.force_bound * window);
  for (const Contact &contact : motion.mode->contacts) {
    const StopState &stop = run.stops[contact.stop];
    const bool bounces = stop.falling > 0 && is<ExactZeros>(stop.at);
    if (contact.held || !bounces) continue;
    const Value value = evaluate(chain, contact, motion);
    if (rounded(value.value) <= rounding * window && std::abs(value.slope.hi) <= rounding)
      add_resting(run, contact, 0);
  }
}

void gather_resting(Run &run) {
  run.scratch.resting.clear();
  const List<Contact> &contacts = run.motion.mode->contacts;
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const AtStop &at = run.stops[contacts[k].stop].at;
    if (contacts[k].held)
      add_resting(run, contacts[k],
                  known_zeros_of(run, k, evaluate(run.chain(), contacts[k], run.motion)));
    else if (is<Resting>(at) || is_idle(at))
      add_resting(run, contacts[k], 0);
  }
  if (!run.scratch.resting.empty()) question_dead_bounces(run);
}

// Sets the states of the stops of a mass after its decision.
void set_stops(Run &run, const RestingMass &mass) {
  StopState &stop = run.stops[mass.contact.stop];
  stop.at = mass.at;
  if (mass.held == mass.contact.held) return;
  stop = {.at = stop.at, .changed = run.motion.now.rounded(), .unreported = stop.unreported};
  for (const Contact &other : run.chain().stops)
    if (!mass.held && other.stop != mass.contact.stop && other.mass == mass.contact.mass)
      run.stops[other.stop] = {};
}

// Reports the event of a mass that was in question, if it has one: a stick, a release, or the limit
// of a chatter from which it leaves at once. While that is ahead nothing is decided for good.
void report_decision(Run &run, const RestingMass &mass, Recorders recorders) {
  StopState &stop = run.stops[mass.contact.stop];
  if (run.limit.is_ahead || is<Postponed>(stop.at)) return;
  const ImpactSum taken = std::exchange(stop.unreported, {});
  const bool released = mass.contact.held && !mass.held;
  if (mass.held != mass.contact.held)
    report_event(run, released ? EventKind::release : EventKind::stick, mass.contact.stop, 0.0, 0.0,
                 released && mass.known_zeros == 0, taken, recorders);
  else if (taken != ImpactSum{})
    report_event(run, EventKind::impact, mass.contact.stop, 0.0, 0.0, false, taken, recorders);
}

}  // namespace

void hold_or_release(Run &run, Recorders recorders) {
  gather_resting(run);
  Scratch &scratch = run.scratch;
  Motion &motion = run.motion;
  const Chain &chain = run.chain();
  if (scratch.resting.empty()) return;
  if (motion.turned > 0) set_turn(chain, motion);  // without the rounding of the steps since
  for (const RestingMass &mass : scratch.resting)
    place(mass.contact.mass, mass.contact.position, 0.0, motion);
  run.counters.rest_orders += scratch.rest.decide(chain, motion, scratch.resting);
  scratch.held = motion.mode->held;
  for (RestingMass &mass : scratch.resting) {
    const std::optional<Instant> &changed = run.stops[mass.contact.stop].changed;
    // A mass does not stick and leave, or leave and stick, at one instant of the clock.
    if (mass.held != mass.contact.held && changed && !(*changed < motion.now.rounded())) {
      run.stops[mass.contact.stop].at = Postponed{};
      mass.held = mass.contact.held;
    } else {
      set_stops(run, mass);
    }
    scratch.held[mass.contact.mass] =
        static_cast<signed char>(mass.held ? mass.contact.sigma : 0.0);
  }
  if (scratch.held != motion.mode->held) {
    motion.mode = &run.modes.enter(chain, scratch.held, run.counters);
    motion.acceleration_known = false;
  }
  for (const RestingMass &mass : scratch.resting) {
    if (mass.held != mass.contact.held) ++(mass.held ? run.counters.sticks : run.counters.releases);
    report_decision(run, mass, recorders);
  }
}

void forget_instant(Run &run) {
  for (const Contact &contact : run.motion.mode->contacts) {
    AtStop &at = run.stops[contact.stop].at;
    if (is<Forceless>(at) ? !gap_of(contact, run.motion).is_zero() : !is<Postponed>(at))
      at = ExactZeros{};
  }
}

void handle_instant(Run &run, Recorders recorders) {
  gather_hits(run);
  apply_hits(run, recorders);
  hold_or_release(run, recorders);
}

void put_at_start(Run &run) {
  const Chain &chain = run.chain();
  const MotionState state = *std::exchange(run.start, std::nullopt);
  Motion &motion = run.motion;
  motion.mode = &run.modes.enter(chain, state.held, run.counters);
  clear(chain, motion);
  motion.now = TwofoldInstant(state.instant);
  for (std::size_t i = 0; i < chain.masses; ++i)
    place(i, state.displacement[i], state.velocity[i], motion);
  set_turn(chain, motion);
  run.stops.assign(chain.stops.size(), {});
  run.scratch.near.assign(motion.mode->contacts.size(), Near::perhaps);
}

}  // namespace vibro_impact::detail
