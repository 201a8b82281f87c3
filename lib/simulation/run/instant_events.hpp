// What happens at one instant: impacts, who is held after it, and the chatter it may belong to.
#pragma once

#include "run.hpp"
#include "simulation/chatter/limit.hpp"

namespace vibro_impact {

// Counts an impact at this closing speed, and whether the impacts at its stop go on falling.
template <int D>
void count_impact(Run<D> &run, AtStop &stop, double speed) {
  ++run.counters.impacts;
  const bool falls = speed < stop.last_speed;
  if (!falls && stop.falling >= 5) ++run.counters.chatter_incomplete;
  stop.falling = falls ? stop.falling + 1 : 0;
  stop.last_speed = speed;
  if (run.silent) return;
  State<D> &state = run.state;
  if (!(elapsed(state.window_start, state.now, run.clock) <= run.window)) {
    state.window_start = state.now;
    state.impacts_in_window = 0;
  }
  if (++state.impacts_in_window > run.options.max_impacts_per_period)
    give_up(run, line("more than ", run.options.max_impacts_per_period,
                      " impacts in one period, given up at t = ", time_of(state.now, run.clock)));
}

// True when a speed at this stop is lost in the rounding of those the chain moves at.
template <int D>
bool is_lost(const State<D> &state, const Contact<D> &contact, double speed) {
  return speed < lost * (contact.watched.on_value * state.slope).abs().sum();
}

// Applies the impacts at `run.hits`. A chatter of which what is left lies below rounding is over:
// its mass is at rest, whatever else happens within that rounding.
template <int D>
void apply_impacts(Run<D> &run) {
  State<D> &state = run.state;
  const ContactMode<D> &mode = *state.mode;
  for (const std::size_t k : run.hits) {
    AtStop &stop = state.stops[mode.contacts[k].stop];
    const double closing = std::max(0.0, -stop.speed);
    count_impact(run, stop, closing);
    leave_stop(state, mode.contacts[k],
               law_of(run.scene, run.scene.stops[mode.contacts[k].stop]).after(closing));
  }
  for (const std::size_t k : run.hits) {
    const Contact<D> &contact = mode.contacts[k];
    const AtStop &stop = state.stops[contact.stop];
    tell(run, EventKind::impact, contact.stop, contact.sigma * stop.last_speed,
         -contact.sigma * stop.speed, false);
  }
  for (const std::size_t k : run.hits) {
    const Contact<D> &contact = mode.contacts[k];
    const double left = next_flight(state, run.scene, contact) / (1.0 - contact.restitution);
    const double speed = state.stops[contact.stop].speed;
    const bool over = left * mode.fastest < same_instant || is_lost(state, contact, speed);
    if (!(speed > 0.0 && over)) continue;
    leave_stop(state, contact, 0.0);
    ++run.counters.chatter_limits;
  }
}

// True when the dampers pass the jump of a speed on to this mass.
template <int D>
bool is_pushed(const Run<D> &run, std::size_t mass) {
  return run.scene.beta > 0.0 &&
         std::any_of(run.hits.begin(), run.hits.end(), [&](std::size_t hit) {
           const Contact<D> &contact = run.state.mode->contacts[hit];
           return (contact.mass + 1 == mass || mass + 1 == contact.mass) &&
                  !is_lost(run.state, contact, run.state.stops[contact.stop].last_speed);
         });
}

// Gathers the masses at rest on a stop whose force is in question: those not held, those whose
// force has come to zero, those decided at this very instant before, and those beside an impact
// that are not pressed clearly. Before the first flight of a run every mass held is in question.
template <int D>
void gather_resting(Run<D> &run, bool at_start) {
  const State<D> &state = run.state;
  run.question.resting.clear();
  for (std::size_t k = 0; k < state.mode->contacts.size(); ++k) {
    const Contact<D> &contact = state.mode->contacts[k];
    const AtStop &stop = state.stops[contact.stop];
    if (!contact.held && !(stop.gap == 0.0 && stop.speed == 0.0)) continue;
    const bool root = std::find(run.roots.begin(), run.roots.end(), k) != run.roots.end(),
               pushed = is_pushed(run, contact.mass);
    if (contact.held && !root && !at_start && !stop.decided &&
        !(pushed && !is_wide(state, contact)))
      continue;
    // The force is zero now, or was at this very instant before, unless it has jumped since. (A
    // mass that is released and hits at one instant would be held again by the rounding of the
    // force.)
    const bool zero = root || !(stop.force_was_zero < state.now) || stays_at_rest(stop);
    run.question.resting.push_back(
        {contact.stop, contact.mass, contact.sigma, contact.held, zero && !pushed});
  }
}

// Decides who is held after the instant, for all masses in question at once, and enters the contact
// mode that follows. At the start of a run its motion is known exactly, and stands there already.
template <int D>
void hold_or_release(Run<D> &run, bool at_start = false) {
  gather_resting(run, at_start);
  if (run.question.resting.empty()) return;
  State<D> &state = run.state;
  if (at_start) {
    run.question.error.assign(run.scene.mass.size(), 0.0);
  } else {
    set_motion(state, run.scene, run.motion);
    set_rounding(state, run.scene, run.scene_rate, run.question.error);
  }
  decide(run.scene, run.motion, run.scene_rate, run.question);
  Held &held = run.motion.held;
  for (const Resting &mass : run.question.resting) {
    AtStop &stop = state.stops[mass.stop];
    set_at_rest(stop, mass.zeros, mass.leading);
    if (mass.zeros > 0) stop.force_was_zero = state.now;
    held[mass.mass] = static_cast<signed char>(mass.held ? mass.sigma : 0.0);
    if (mass.held == mass.was_held) continue;
    stop.falling = 0;
    stop.last_speed = 0.0;
    if (mass.held) continue;
    for (std::size_t k = 0; k < run.scene.stops.size(); ++k) {  // a stop across is there again
      const Stop &other = run.scene.stops[k];
      if (k == mass.stop || other.mass != run.scene.stops[mass.stop].mass) continue;
      state.stops[k] = {.gap = std::abs(other.position - run.scene.stops[mass.stop].position)};
    }
  }
  if (held == state.mode->held) return;
  set_lanes(state, run.scene, run.modes.enter(run.scene, held, run.counters), run.motion);
  for (const Resting &mass : run.question.resting) {
    if (mass.held == mass.was_held) continue;
    ++(mass.held ? run.counters.sticks : run.counters.releases);
    tell(run, mass.held ? EventKind::stick : EventKind::release, mass.stop, 0.0, 0.0,
         !mass.held && !mass.force_is_zero);
  }
}

// Moves on to the end of the run or to `then`, whichever is earlier, impact by impact without
// telling anybody of them: for samples, and an end, inside a chatter that is carried to its limit.
template <int D>
void look_inside(Run<D> &run, const Instant &then);

// Carries a chatter that has come to a node to its limit, where that is certain.
template <int D>
void take_limit(Run<D> &run) {
  Chatter<D> &chatter = run.chatter;
  State<D> &state = run.state;
  const double fastest = state.mode->fastest;
  if (run.over || run.silent || !chatter.at_node()) return;
  // The next impact may come in a little faster than the latest went out.
  for (const std::size_t k : chatter.impacts.contacts)
    if (!(next_speed * state.stops[state.mode->contacts[k].stop].speed <
          run.options.resolve_chatter))
      return;
  const auto limit = extrapolate(chatter, run.options.chatter_tolerance / fastest);
  if (!limit || !(limit->left * fastest <= max_reach)) return;
  if (!others_stay_clear(chatter, state, limit->left)) return;
  Expansion path;
  expand(fastest, limit->left, run.options.flight_tolerance, path, run.counters);
  State<D> &there = run.at_limit;
  const double error = move_to_limit(chatter, *limit, run.scene, run.clock, run.scene_rate, path,
                                     state, there, run.counters);
  if (chatter.table.error * fastest + error > run.options.chatter_tolerance) return;
  for (const std::size_t k : chatter.impacts.contacts)  // let go there: a border orbit or beyond
    if (!(state.mode->contacts[k].press(there.value, there.slope) > 0.0)) return;
  const Instant then = there.now;
  if (run.end < then || next_sample(run) <= time_of(then, run.clock)) {
    look_inside(run, then);
    if (run.over) return;
  }
  state = there;
  chatter.end();
  ++run.counters.chatter_limits;
  run.hits.clear();
  run.roots.clear();
  hold_or_release(run);
}

// After impacts at `run.hits`: the flight expected next, and the chatter they may belong to. Not
// where the contact mode has changed from `mode`, or a mass was left at rest.
template <int D>
void follow_chatter(Run<D> &run, const ContactMode<D> *mode) {
  State<D> &state = run.state;
  double flight = 0.0;
  bool leaving = !run.hits.empty() && state.mode == mode;
  for (const std::size_t k : run.hits) {
    leaving = leaving && state.stops[mode->contacts[k].stop].speed > 0.0;
    if (leaving) flight = std::max(flight, next_flight(state, run.scene, mode->contacts[k]));
  }
  if (!leaving) return run.chatter.end();
  state.span_expected = beyond_expected * flight;
  note_impacts(run.chatter, state, run.hits, flight, run.counters);
  take_limit(run);
}

// The events at the end of the flight, to which the state has been moved.
template <int D>
void handle_instant(Run<D> &run) {
  const ContactMode<D> *mode = run.state.mode;
  run.hits.clear();
  run.roots.clear();
  for (std::size_t k = 0; k < mode->contacts.size(); ++k)
    if (run.flight.watched[k].root) (mode->contacts[k].held ? run.roots : run.hits).push_back(k);
  apply_impacts(run);
  hold_or_release(run);
  follow_chatter(run, mode);
}

}  // namespace vibro_impact
