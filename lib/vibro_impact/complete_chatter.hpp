// Chatter within a run: followed impact by impact, and carried to its limit when that is certain.
//
// A chatter that is over within the rounding of the time is at rest, whatever else happens within
// that rounding: so chatters of several masses that end together do not keep each other alive.
#pragma once

#include "at_a_stop.hpp"

namespace vibro_impact::detail {

// Time to the next impact at the slowest of `stops`, to leading order; infinite where a mass is not
// pressed.
template <int D>
double longest_flight(const Run<D> &run, const std::vector<std::size_t> &stops) {
  double longest = 0.0;
  for (const std::size_t stop : stops) {
    const OpenStop<D> &open = open_stop(run.state, stop);
    const double press = open.press(run.state.value, run.state.slope);
    longest = std::max(
        longest, press > 0.0 ? 2.0 * run.state.stops[stop].speed * run.scene.mass[open.mass] / press
                             : std::numeric_limits<double>::infinity());
  }
  return longest;
}

// Masses that chatter in step lose it by rounding: impacts at one instant become several, in any
// order. Adds those just applied to the ones of this instant.
template <int D>
void gather(Run<D> &run, const std::vector<std::size_t> &hit, double since_last) {
  auto &together = run.chatter.together;
  if (since_last * run.state.mode->fastest > same_instant) together.clear();
  for (const std::size_t stop : hit)
    if (std::find(together.begin(), together.end(), stop) == together.end())
      together.insert(std::upper_bound(together.begin(), together.end(), stop), stop);
}

// A chatter of which the next flight comes to no more than `flight` is over within rounding: to
// rest at once. False where it is not.
template <int D>
bool ends_at_once(Run<D> &run, const std::vector<std::size_t> &hit, double flight) {
  State<D> &state = run.state;
  const double left = flight / (1.0 - run.scene.restitution);
  if (!(left * state.mode->fastest < same_instant)) return false;
  if (!(left < elapsed(state.now, run.end, run.clock))) return false;
  const ContactMode<D> &mode = *state.mode;
  for (const std::size_t stop : hit) place_at_stop(state, run.scene, open_stop(state, stop), 0.0);
  for (const OpenStop<D> &open : mode.open) {
    refresh(state, open);
    StopState &stop = state.stops[open.stop];
    stop.gap = std::max(0.0, stop.gap + left * stop.speed);
  }
  state.value += left * state.slope;
  state.now = later(state.now, left, run.clock);
  set_forcing(state, run.scene);
  for (const std::size_t stop : hit) state.stops[stop] = {};
  for (const std::size_t stop : hit) stick_at(run, stop);
  ++run.counters.chatter_limits;
  return true;
}

// Carries the chatter to its limit when that is certain.
template <int D>
bool take_chatter_limit(Run<D> &run) {
  Chatter<D> &chatter = run.chatter;
  Bounces<D> &bounces = chatter.bounces;
  State<D> &state = run.state;
  const double fastest = state.mode->fastest;
  const bool resolved = state.stops[bounces.stops[0]].speed < run.options.resolve_chatter;
  const auto limit =
      extrapolate(chatter.table, fastest, resolved ? run.options.chatter_tolerance : -1.0);
  if (!limit || !(limit->left > 0.0 && limit->left * fastest <= max_reach)) return false;
  const Instant then = later(state.now, limit->left, run.clock);
  if (!(then < run.end) || samples_by(run, then)) return false;
  const double error = find_tail(bounces, state, chatter.table, *limit, chatter.tail, run.counters);
  if (limit->nodes > 1 && limit->error + 0.1 * error * fastest > run.options.chatter_tolerance)
    return false;
  refresh_stops(bounces, state);
  if (!undisturbed(bounces, state, chatter.tail, run.counters)) return false;

  move_to_limit(bounces, chatter.tail, run.scene, then, state, chatter.before, run.counters);
  const std::vector<std::size_t> &stops = bounces.stops;
  for (std::size_t stop : stops)
    if (!(open_stop(state, stop).press(state.value, state.slope) > 0.0)) {
      std::swap(state, chatter.before);  // a border orbit or beyond: the chatter is not complete
      return false;
    }
  for (std::size_t stop : stops) stick_at(run, stop);
  ++run.counters.chatter_limits;
  return true;
}

// Follows the bounces impact by impact, as long as nothing else happens. True when they have come
// to rest.
template <int D>
bool follow_bounces(Run<D> &run) {
  Chatter<D> &chatter = run.chatter;
  Bounces<D> &bounces = chatter.bounces;
  for (long long impact = 0;; ++impact) {
    if (impact % run.stride == 0) {
      extend(chatter.table, predict_limit(bounces));
      ++run.counters.chatter_nodes;
      if (take_chatter_limit(run)) return true;
    }
    if (!find_next(bounces, run.state, run.counters)) return false;
    const Instant then = later(run.state.now, bounces.flight, run.clock);
    if (!(then < run.end)) return false;
    sample_flight(run, bounces.flight);
    fly(bounces, run.state, run.scene, then);
    const bool on = bounce(bounces, run.state, run.scene, run.closing);
    record_impacts(run, bounces.stops);
    if (!on) return false;
    if (ends_at_once(run, bounces.stops, bounces.flight)) return true;
    look_on(bounces, run.state, run.counters);
  }
}

// After impacts at the stops `hit`.
template <int D>
void follow_chatter(Run<D> &run, const std::vector<std::size_t> &hit, double since_last) {
  Chatter<D> &chatter = run.chatter;
  const double fastest = run.state.mode->fastest;
  gather(run, hit, since_last);
  double flight = longest_flight(run, hit);
  run.flight_guess = 1.1 * flight;
  if (!(flight * fastest < 1.0)) return;
  if (ends_at_once(run, hit, flight)) return;
  flight = longest_flight(run, chatter.together);
  if (!(flight * fastest < 1.0)) return;
  chatter.table.size = 0;
  chatter.table.power = chatter.together.size() == 1 ? 5 : 3;
  if (!follow(chatter.bounces, run.state, run.scene, chatter.together, flight, run.counters) ||
      follow_bounces(run))
    return;
  refresh_stops(chatter.bounces, run.state);
  run.flight_guess = 1.1 * longest_flight(run, chatter.together);
  settle_after(run, chatter.bounces.stops);
}

}  // namespace vibro_impact::detail
