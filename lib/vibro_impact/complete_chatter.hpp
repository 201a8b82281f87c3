// Chatter within a run: followed on the gaps alone, and carried to its limit when that is certain.
//
// A chatter that is over within the rounding of the time is at rest, whatever else happens within
// that rounding: so chatters of several masses that end together do not keep each other alive.
#pragma once

#include <optional>

#include "at_a_stop.hpp"
#include "chatter_limit.hpp"
#include "next_bounce.hpp"

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

// A chatter that is over after `left`, within rounding: to rest at once.
template <int D>
void end_at_once(Run<D> &run, const std::vector<std::size_t> &hit, double left) {
  State<D> &state = run.state;
  const ContactMode<D> &mode = *state.mode;
  for (const std::size_t stop : hit) place_at_stop(state, run.scene, open_stop(state, stop), 0.0);
  for (const OpenStop<D> &open : mode.open) {
    StopState &stop = state.stops[open.stop];
    stop.gap = std::max(0.0, stop.gap + left * stop.speed);
  }
  state.value += left * state.slope;
  state.now = later(state.now, left, run.clock);
  set_forcing(state, run.scene);
  for (const std::size_t stop : hit) state.stops[stop] = {};
  for (const std::size_t stop : hit) stick_at(run, stop);
  ++run.counters.chatter_limits;
}

// Largest reach of a path: the expansion has all its terms, and loses a digit or two.
constexpr double longest_reach = 4.0;

enum class Followed { to_rest, as_far_as_covered, to_something_else };

// Carries the chatter that is followed to its limit when that is certain, or finds the limit to lie
// beyond what is covered; nothing where the next impact has to be looked for.
template <int D>
std::optional<Followed> take_chatter_limit(Run<D> &run) {
  Chatter<D> &chatter = run.chatter;
  const Bounces<D> &bounces = chatter.bounces;
  const double fastest = run.state.mode->fastest;
  const bool resolved = bounces.speed(0) < run.options.resolve_chatter;
  const auto limit =
      extrapolate(chatter.table, fastest, resolved ? run.options.chatter_tolerance : -1.0);
  if (!limit || !(limit->left > 0.0)) return std::nullopt;
  if (bounces.time + limit->left > bounces.covered) {
    if (limit->left * fastest < longest_reach) return Followed::as_far_as_covered;
    return std::nullopt;
  }
  const Instant now = run.state.now, then = later(now, limit->left, run.clock);
  if (!(then < run.end) || samples_by(run, then)) return std::nullopt;
  const double error = find_tail(bounces, chatter.table, *limit, chatter.tail);
  if (limit->nodes > 1 && limit->error + 0.1 * error * fastest > run.options.chatter_tolerance)
    return std::nullopt;
  if (!undisturbed(bounces, chatter.tail)) return std::nullopt;

  run.state.now = then;
  set_state_after(bounces, chatter.tail, run.scene, run.state);
  const std::vector<std::size_t> &stops = bounces.stops;
  for (std::size_t stop : stops)
    if (!(open_stop(run.state, stop).press(run.state.value, run.state.slope) > 0.0)) {
      run.state.now = now;  // a border orbit or beyond: the chatter is not complete
      chatter.ahead = true;
      return std::nullopt;
    }
  chatter.ahead = false;
  for (std::size_t stop : stops) run.state.stops[stop] = {};
  for (std::size_t stop : stops) stick_at(run, stop);
  ++run.counters.chatter_limits;
  return Followed::to_rest;
}

// Follows the bounces impact by impact, as long as nothing else happens.
template <int D>
Followed follow_bounces(Run<D> &run) {
  Chatter<D> &chatter = run.chatter;
  Bounces<D> &bounces = chatter.bounces;
  while (true) {
    const std::size_t impact = bounces.times.size() - 1;
    if (static_cast<long long>(impact) % run.stride == 0) {
      if (impact == 0 || impact > bounces.base) {  // not in the table already
        extend(chatter.table, predict_limit(bounces));
        ++run.counters.chatter_nodes;
        if (chatter.table.size > 0)
          expect_end(bounces, 1.25 * chatter.table.nodes[chatter.table.size - 1].tail);
      }
      if (const auto followed = take_chatter_limit(run)) return *followed;
    }
    if (!find_next(bounces, run.counters)) return Followed::as_far_as_covered;
    const double flight = bounces.flight;
    const Instant then = later(run.state.now, flight, run.clock);
    if (!(then < run.end)) return Followed::to_something_else;
    if (samples_by(run, then)) {
      state_of(run);
      sample_flight(run, flight);
    }
    bounce(bounces, run.scene, run.closing);
    run.state.now = then;
    chatter.ahead = true;
    record_impacts(run, bounces.stops);
    if (!goes_on(bounces)) return Followed::to_something_else;
  }
}

// After impacts at the stops `hit`.
template <int D>
void follow_chatter(Run<D> &run, const std::vector<std::size_t> &hit, double since_last) {
  Chatter<D> &chatter = run.chatter;
  const double r = run.scene.restitution, fastest = run.state.mode->fastest;
  gather(run, hit, since_last);
  double flight = longest_flight(run, hit);
  run.flight_guess = 1.1 * flight;
  if (!(flight * fastest < 1.0)) return;
  const double left = flight / (1.0 - r);
  if (left * fastest < same_instant) {
    if (left < elapsed(run.state.now, run.end, run.clock)) end_at_once(run, hit, left);
    return;
  }
  flight = longest_flight(run, chatter.together);
  if (!(flight * fastest < 1.0)) return;
  chatter.table.size = 0;
  chatter.table.power = chatter.together.size() == 1 ? 4 : 3;
  for (bool on = false;; on = true) {
    const double covered =
        std::min(1.25 * flight / (1.0 - r), (on ? longest_reach : max_reach) / fastest);
    if (!follow(chatter.bounces, run.state, run.scene, chatter.together, flight, covered, on,
                run.counters))
      return;
    const Followed followed = follow_bounces(run);
    if (followed == Followed::to_rest) return;
    state_of(run);
    flight = longest_flight(run, chatter.together);
    run.flight_guess = 1.1 * flight;
    if (followed == Followed::to_something_else) break;
    if (chatter.bounces.times.size() - 1 == chatter.bounces.base || !(flight * fastest < 1.0))
      break;
    for (ChatterNode &node : chatter.table.nodes) node.limit -= chatter.bounces.time;
  }
  settle_after(run, chatter.bounces.stops);
}

}  // namespace vibro_impact::detail
