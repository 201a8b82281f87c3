#include "events_at_an_instant.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "observers.hpp"
#include "simulation/chain/pair.hpp"
#include "simulation/chain/require.hpp"
#include "simulation/chain/tolerances.hpp"
#include "simulation/stops/impact.hpp"

namespace vibro_impact::detail {

namespace {

// The gap of a contact in the initial state.
Gap start_gap(const Scene &scene, const Contact &contact, const MotionState &state) {
  const double position = scene.stops[contact.stop].position;
  return {contact.sigma * (position - state.displacement[contact.mass]),
          -contact.sigma * state.velocity[contact.mass]};
}

// Enters the contact mode state.held. At the start of a run `state` is exact and gives the modal
// coordinates; later the coordinates of the mode before give them. A small gap is more accurate
// than the coordinates of the new mode, and is placed.
void enter_mode(Run &run, const MotionState &state, bool at_start) {
  bool built = false;
  const ContactMode &mode = run.modes.enter(run.scene(), state.held, built);
  if (built) ++run.counters.modes_built;
  std::vector<std::optional<Gap>> &gaps = run.scratch.gaps;
  gaps.assign(run.scene().stops.size(), std::nullopt);
  if (at_start) {
    express(run.scene(), state, mode, run.problem.clock, run.scratch.chain, run.motion);
    for (const Contact &contact : mode.contacts)
      gaps[contact.stop] = start_gap(run.scene(), contact, state);
  } else {
    for (const Contact &contact : run.motion.mode->contacts)
      gaps[contact.stop] = gap_of(contact, run.stops[contact.stop], run.motion);
    change_mode(mode, run.scratch.chain, run.motion);
  }
  Placement &placed = run.scratch.placed;
  placed.clear();
  for (const Contact &contact : mode.contacts) {
    const std::optional<Gap> &gap = gaps[contact.stop];
    if (gap && !contact.held && !is_resolved(contact, run.motion)) placed.add(contact, *gap);
  }
  placed.apply(run.motion);
}

// Counts an impact at a stop, at this closing speed, among those of its chatter.
void count_impact(Run &run, StopState &stop, double speed) {
  ++run.counters.impacts;
  const bool falls = speed < stop.last_speed;
  if (!falls && stop.falling >= chatter_impacts) ++run.counters.chatter_incomplete;
  stop.falling = falls ? stop.falling + 1 : 0;
  stop.last_speed = speed;
  const double flight = elapsed(stop.left, run.motion.now, run.problem.clock);
  stop.duration = std::max(falls ? stop.duration : 0.0, flight);
  stop.left = run.motion.now;
}

// Applies the impacts at the contacts hit, then reports them. Simultaneous impacts act on different
// masses, so that their order matters to rounding only. A mass comes to rest at once when the time
// left to the limit of its chatter, or its rebound speed, lies below rounding.
void apply_impacts(Run &run, std::span<const std::size_t> hits, Recorders recorders) {
  Motion &motion = run.motion;
  const ContactMode &mode = *motion.mode;
  run.scratch.flight_times.clear();
  for (const std::size_t k : hits) {
    const Contact &contact = mode.contacts[k];
    StopState &stop = run.stops[contact.stop];
    const double closing = std::max(0.0, -stop.contact.speed.value_or(0.0));
    count_impact(run, stop, closing);
    const ImpactLaw law = law_of(run.scene(), run.scene().stops[contact.stop]);
    leave_stop(contact, law.after(closing), motion, run.stops);
  }
  for (const std::size_t k : hits) {
    const Contact &contact = mode.contacts[k];
    const StopState &stop = run.stops[contact.stop];
    report_event(run, EventKind::impact, contact.stop,
                 {contact.sigma * stop.last_speed, -contact.sigma * *stop.contact.speed}, false,
                 recorders);
  }
  for (const std::size_t k : hits) {
    const Contact &contact = mode.contacts[k];
    StopState &stop = run.stops[contact.stop];
    const double speed = *stop.contact.speed;
    run.scratch.flight_times.push_back(next_flight(run.scene(), contact, speed, motion));
    if (!(speed > 0.0)) continue;
    const double time_left = run.scratch.flight_times.back() / (1.0 - contact.restitution);
    if (std::isfinite(time_left)) stop.duration = std::max(stop.duration, time_left);
    const double unit = unit_of_time(mode, stop);
    if (!(time_left < same_instant * unit) && !is_negligible(contact, speed, motion)) continue;
    leave_stop(contact, 0.0, motion, run.stops);
    ++run.counters.chatter_limits;
  }
}

// True when a neighbour has an impact and the damper between them passes on the jump of its speed.
bool is_pushed(const Run &run, std::span<const std::size_t> hits, std::size_t mass) {
  if (!(run.scene().beta > 0.0)) return false;
  return std::any_of(hits.begin(), hits.end(), [&](std::size_t hit) {
    const Contact &contact = run.motion.mode->contacts[hit];
    return (contact.mass + 1 == mass || mass + 1 == contact.mass) &&
           !is_negligible(contact, run.stops[contact.stop].last_speed, run.motion);
  });
}

// Gathers the masses at rest at a stop whose force is in question. A mass that is not held is in
// question. A held mass is in question when its force is zero at this instant, when its force was
// decided at this instant before, when its decision was postponed, or when the force has jumped to
// a value that is small or negative. At the start of a run every held mass is in question. Later a
// mass whose bounces have died down is in question with the others: in flight, its acceleration
// would be the rounding of theirs.
void gather_resting(Run &run, const ContactsOfInstant &contacts, bool at_start) {
  const ContactMode &mode = *run.motion.mode;
  const std::span<const std::size_t> roots = contacts.roots;
  std::vector<RestingMass> &masses = run.scratch.rest.masses;
  masses.clear();
  for (std::size_t k = 0; k < mode.contacts.size(); ++k) {
    const Contact &contact = mode.contacts[k];
    const StopState &stop = run.stops[contact.stop];
    const std::optional<DecidedForce> &decided = stop.contact.decided;
    if (!contact.held && !stop.contact.at_rest && stop.contact.speed != 0.0) continue;
    const bool root = std::find(roots.begin(), roots.end(), k) != roots.end();
    const bool pushed = is_pushed(run, contacts.hits, contact.mass);
    const bool in_question = !contact.held || at_start || root || decided ||
                             stop.contact.postponed ||
                             (pushed && !is_resolved(contact, run.motion));
    if (!in_question) continue;
    // The force is exactly zero at a root, or as decided at this instant before, unless it jumps. A
    // force that is already negative is no root.
    const bool zero =
        (root && evaluate(contact, run.motion) >= -row_rounding * terms_of(contact, run.motion)) ||
        (decided && (decided->zeros > 0 || decided->none));
    masses.push_back({contact.stop, contact.mass, contact.sigma, contact.held, zero && !pushed});
  }
  if (masses.empty() || at_start) return;
  // Within 1 / rate, the motion of the chain and the forcing move a mass at most so far.
  const double rate = run.problem.rate_bound, speed = dot_moduli(mode.extent, run.motion.dy);
  for (const Contact &contact : mode.contacts) {
    const AtStop &state = run.stops[contact.stop].contact;
    if (contact.held || state.at_rest || state.speed == 0.0) continue;
    const Gap gap = gap_of(contact, run.stops[contact.stop], run.motion);
    const double acceleration = run.problem.forcing_bound / run.scene().mass[contact.mass],
                 reach = (speed + acceleration / rate) / rate;
    if (!is_as_at_rest(gap, reach, rate)) continue;
    leave_stop(contact, 0.0, run.motion, run.stops);
    masses.push_back({contact.stop, contact.mass, contact.sigma, false, false});
  }
}

// Sets the state of the stop of a mass after its decision, and of the opposite stop if the mass is
// released.
void set_stops(Run &run, const RestingMass &mass) {
  const std::vector<Stop> &stops = run.scene().stops;
  StopState &stop = run.stops[mass.stop];
  stop.contact = {
      .at_rest = true, .decided = mass.force, .released = !mass.held && !mass.force.none};
  if (mass.held == mass.was_held) return;
  stop.changed = stop.left = run.motion.now;
  stop.falling = 0;
  stop.last_speed = 0.0;
  for (std::size_t k = 0; k < stops.size() && !mass.held; ++k)
    if (k != mass.stop && stops[k].mass == stops[mass.stop].mass)
      run.stops[k] = {.left = run.motion.now};
}

// Adds the impacts of this instant to the chatter that they continue or begin, and sets the step
// hint to the longest flight expected after them. The chatter ends at an instant without impacts,
// with a mass left at rest, or with another contact mode than `previous_mode`.
void follow_chatter(Run &run, const std::vector<std::size_t> &hits,
                    const ContactMode &previous_mode) {
  const ContactMode &mode = *run.motion.mode;
  std::vector<double> &jumps = run.scratch.jumps;
  jumps.clear();
  double flight_time = 0.0;
  bool leaving = !hits.empty() && &mode == &previous_mode;
  for (std::size_t i = 0; i < hits.size() && leaving; ++i) {
    const Contact &contact = mode.contacts[hits[i]];
    const StopState &stop = run.stops[contact.stop];
    const double speed = stop.contact.speed.value_or(0.0);  // none of a mass at rest
    leaving = speed > 0.0;
    jumps.push_back(stop.last_speed + speed);
    flight_time = std::max(flight_time, run.scratch.flight_times[i]);
  }
  if (!leaving) return end_chatter(run.chatter);
  run.hint.flight_time = flight_time;
  Chatter &chatter = run.chatter;
  if (!(chatter.under_way() && flight_time < chatter.flight_time && hits == chatter.contacts)) {
    end_chatter(chatter);
    const double r = mode.contacts[hits[0]].restitution;
    // With r = 0 one impact stops the mass, and with r = 1 the impacts have no limit. A chatter
    // begins once a flight takes less than a radian of the fastest rate.
    if (!(r > 0.0 && r < 1.0 && (mode.falls || flight_time * mode.fastest < 1.0))) return;
    begin_chatter(chatter, hits, r);
  }
  if (add_impact(chatter, flight_time, jumps, run.motion)) ++run.counters.chatter_nodes;
}

}  // namespace

void stop_run(Run &run, Ending ending, std::string reason) {
  if (run.progress.over) return;
  run.progress.over = true;
  run.progress.ending = ending;
  run.progress.reason = std::move(reason);
}

void hold_or_release(Run &run, const ContactsOfInstant &contacts, Recorders recorders,
                     bool at_start) {
  gather_resting(run, contacts, at_start);
  RestDecision &rest = run.scratch.rest;
  if (rest.masses.empty()) return;
  MotionState &state = run.scratch.state;
  const double rate = run.problem.rate_bound;
  if (at_start) {
    rest.decide(run.scene(), state, rate);
  } else {
    state.held = run.motion.mode->held;
    set_chain(run.motion, run.scratch.chain);
    rest.decide(run.scene(), state.held, run.scratch.chain, run.motion.now.phase, rate);
  }
  run.counters.rest_orders += rest.orders;
  for (RestingMass &mass : rest.masses) {
    const std::optional<Instant> &changed = run.stops[mass.stop].changed;
    // A mass does not stick and leave, or leave and stick, at one instant of the clock.
    if (mass.held != mass.was_held && changed && !(*changed < run.motion.now)) {
      run.stops[mass.stop].contact = {.at_rest = true, .postponed = true};
      run.hint = {.quiet = false, .postponed = true};
      mass.held = mass.was_held;
    } else {
      set_stops(run, mass);
    }
    state.held[mass.mass] = static_cast<signed char>(mass.held ? mass.sigma : 0.0);
  }
  if (state.held == run.motion.mode->held) return;
  enter_mode(run, state, at_start);
  for (const RestingMass &mass : rest.masses) {
    if (mass.held == mass.was_held) continue;
    ++(mass.held ? run.counters.sticks : run.counters.releases);
    report_event(run, mass.held ? EventKind::stick : EventKind::release, mass.stop, {},
                 !mass.held && !mass.force_is_zero, recorders);
  }
}

void handle_instant(Run &run, Recorders recorders) {
  const ContactMode &mode = *run.motion.mode;
  Scratch &scratch = run.scratch;
  scratch.hits.clear();
  scratch.roots.clear();
  for (std::size_t k = 0; k < mode.contacts.size(); ++k)
    if (scratch.flight.approaches[k].root)
      (mode.contacts[k].held ? scratch.roots : scratch.hits).push_back(k);
  apply_impacts(run, scratch.hits, recorders);
  hold_or_release(run, {scratch.hits, scratch.roots}, recorders);
  follow_chatter(run, scratch.hits, mode);
}

void handle_start(Run &run, Recorders recorders) {
  Scratch &scratch = run.scratch;
  MotionState &state = scratch.state;
  state = *std::exchange(run.start, std::nullopt);
  run.motion.now = state.instant;
  enter_mode(run, state, true);
  const std::vector<Stop> &stops = run.scene().stops;
  run.stops.resize(stops.size());
  for (std::size_t k = 0; k < stops.size(); ++k) {
    const auto i = static_cast<std::size_t>(stops[k].mass - 1);
    run.stops[k].left = state.instant;
    if (state.held[i] == static_cast<signed char>(stops[k].side))
      run.stops[k].contact.at_rest = true;
  }
  const ContactMode &mode = *run.motion.mode;
  scratch.hits.clear();
  for (std::size_t k = 0; k < mode.contacts.size(); ++k) {
    const Contact &contact = mode.contacts[k];
    const Gap gap = *scratch.gaps[contact.stop];
    if (contact.held || gap.value != 0.0) continue;
    run.stops[contact.stop].contact.speed = gap.speed;
    if (gap.speed < 0.0) scratch.hits.push_back(k);
  }
  apply_impacts(run, scratch.hits, recorders);
  for (const std::size_t k : scratch.hits) {
    const Contact &contact = mode.contacts[k];
    state.velocity[contact.mass] = -contact.sigma * *run.stops[contact.stop].contact.speed;
  }
  hold_or_release(run, {.hits = scratch.hits}, recorders, true);
  follow_chatter(run, scratch.hits, mode);
}

}  // namespace vibro_impact::detail
