// The impacts of a chatter, one short flight after another.
//
// From one impact to the next only the gaps of the masses hit are followed, over the flight that is
// expected: its polynomial has few terms, and predicts the limit of the chatter as well. The other
// stops are out of reach, at the price of one comparison for the rest of the chatter, or of one per
// flight; only those that are near get a polynomial.
#pragma once

#include <algorithm>
#include <vector>

#include "chatter_series.hpp"
#include "first_event.hpp"
#include "first_return.hpp"
#include "impact.hpp"

namespace vibro_impact {

// Times that differ by less than this, in units of the fastest mode, may differ by rounding: that
// of a period or two of motion.
constexpr double same_instant = 0x1p-46;

template <int D>
struct Bounces {
  using Lanes = typename State<D>::Lanes;

  // A stop hit, with its gap along `path` and where that closes; what a unit jump of the gap speed
  // does to the lanes.
  struct Hit {
    const OpenStop<D> *open = nullptr;
    Polynomial gap;
    Root next;
    Lanes jump_value, jump_slope;
  };
  // A stop near enough to be looked at along `path`.
  struct Near {
    const OpenStop<D> *open = nullptr;
    Polynomial gap;
  };
  std::vector<std::size_t> stops;  // hit together, at every impact
  std::vector<Hit> hits;           // likewise
  // Of gap i to a unit jump of the speed of gap j, responses[i * hit() + j].
  std::vector<Response> responses;
  std::vector<Near> near;
  Expansion path;       // from the latest impact to beyond the next one
  double flight = 0.0;  // to the next one: expected, then found
  double time = 0.0;    // of the latest one, since the first
  ChatterSeries series;
  std::vector<double> times, jumps;  // of the impacts, hit() jumps each
  Lanes push;  // largest modulus of the jump of every slope, per unit jump of a gap speed
  // The other stops are out of reach up to this time, as long as the jumps stay within this sum.
  double clear_until = 0.0, clear_jumps = 0.0;

  std::size_t hit() const {
    return stops.size();
  }
  bool hits_stop(std::size_t stop) const {
    return std::find(stops.begin(), stops.end(), stop) != stops.end();
  }
  double latest_jump() const {
    double sum = 0.0;
    for (std::size_t j = jumps.size() - hit(); j < jumps.size(); ++j) sum += jumps[j];
    return sum;
  }
};

namespace detail {

// True when all other stops are certain to stay as they are for `time`, while the jumps of the gap
// speeds hit come to no more than `jumps`.
template <int D>
bool others_stay_clear(const Bounces<D> &bounces, const State<D> &state, double time,
                       double jumps) {
  const ContactMode<D> &mode = *state.mode;
  const typename State<D>::Lanes speeds = speed_bounds(state, bounces.push, jumps, time);
  for (const OpenStop<D> &open : mode.open)
    if (!bounces.hits_stop(open.stop) && !stays_clear(state, open, speeds, time)) return false;
  for (const ClosedStop<D> &closed : mode.closed)
    if (!stays_clear(state, closed, bounces.push, jumps, speeds, time)) return false;
  return true;
}

// Reads the gaps over the flight expected.
template <int D>
void read_gaps(Bounces<D> &bounces, const State<D> &state, double span, Counters &counters) {
  expand(*state.mode, state.value, state.slope, span, bounces.path, counters);
  for (auto &hit : bounces.hits) read_gap(state, *hit.open, bounces.path, hit.gap, counters);
}

// True when no other stop changes before the next impact.
template <int D>
bool comes_next(Bounces<D> &bounces, State<D> &state, Counters &counters) {
  const ContactMode<D> &mode = *state.mode;
  bounces.near.clear();
  if (bounces.time + bounces.flight <= bounces.clear_until) return true;
  const typename State<D>::Lanes speeds = speed_bounds(state, bounces.push, 0.0, bounces.flight);
  const double u = bounces.hits[0].next.at;
  for (const OpenStop<D> &open : mode.open) {
    if (bounces.hits_stop(open.stop)) continue;
    if (stays_clear(state, open, speeds, bounces.flight)) continue;
    refresh(state, open);
    auto &near = bounces.near.emplace_back();
    near.open = &open;
    read_gap(state, open, bounces.path, near.gap, counters);
    if (first_root(near.gap, 0, u, counters)) return false;
  }
  for (const ClosedStop<D> &closed : mode.closed) {
    if (stays_clear(state, closed, bounces.push, 0.0, speeds, bounces.flight)) continue;
    Polynomial force;
    read_along(mode, closed.press, state.value, state.slope, bounces.path, force, counters);
    if (first_root(force, 0, u, counters)) return false;
  }
  return true;
}

}  // namespace detail

// Starts to follow the impacts at `stops`, which have just happened; the next one is expected after
// `flight`. False where another mass is about to leave its stop.
template <int D>
bool follow(Bounces<D> &bounces, const State<D> &state, const Scene &scene,
            const std::vector<std::size_t> &stops, double flight, Counters &counters) {
  const ContactMode<D> &mode = *state.mode;
  const std::size_t hit = stops.size();
  bounces.stops = stops;
  bounces.hits.resize(hit);
  for (const OpenStop<D> &open : mode.open) {
    const auto place = std::find(stops.begin(), stops.end(), open.stop);
    if (place == stops.end()) {
      if (state.stops[open.stop].zeros != 0) return false;
      continue;
    }
    auto &at = bounces.hits[static_cast<std::size_t>(place - stops.begin())];
    const double sigma = sign(scene.stops[open.stop].side);
    const auto i = static_cast<Eigen::Index>(open.mass);
    at.open = &open;
    at.jump_value = -sigma * mode.velocity_to_modal.col(i).array();
    at.jump_slope = -sigma * mode.to_modal.col(i).array();
    if (mode.any_decay)
      at.jump_slope = mode.decay.select(-mode.kappa * at.jump_value, at.jump_slope);
  }
  for (const ClosedStop<D> &closed : mode.closed)
    if (state.stops[closed.stop].zeros != 0) return false;
  bounces.time = 0.0;
  bounces.times.assign(1, 0.0);
  bounces.jumps.clear();
  bounces.push.setZero(mode.lanes());
  for (const auto &at : bounces.hits) {
    bounces.jumps.push_back((1.0 + scene.restitution) *
                            (state.stops[at.open->stop].speed / scene.restitution));
    bounces.push = bounces.push.max(at.jump_slope.abs());
  }
  bounces.clear_until = bounces.clear_jumps = 0.0;
  bounces.flight = flight;
  detail::read_gaps(bounces, state, 1.2 * flight, counters);
  Expansion start = bounces.path;
  start.order = 7;
  detail::set_powers(start.power, start.rate * start.span, start.order);
  bounces.responses.resize(hit * hit);
  for (std::size_t i = 0; i < hit; ++i)
    for (std::size_t j = 0; j < hit; ++j) {
      Polynomial response;
      read_linear_along(mode, bounces.hits[i].open->gap, bounces.hits[j].jump_value,
                        bounces.hits[j].jump_slope, start, response, counters);
      const double *s = response.coefficient.data(), span = start.span;
      bounces.responses[i * hit + j] = {s[2] / (span * span), s[3] / (span * span * span),
                                        s[4] / (span * span * span * span)};
    }
  bounces.series.set(scene.restitution, bounces.responses[0]);
  return true;
}

// Finds the next impact, `flight` after the latest; false when it is not certain to be the next
// event.
template <int D>
bool find_next(Bounces<D> &bounces, State<D> &state, Counters &counters) {
  // Flights may grow again, where the press falls and r is near one: such are not a chatter's.
  if (!(bounces.path.power[1] <= 0.5 * max_reach)) return false;
  ++counters.flights_followed;
  const auto all_found = [&] {
    for (auto &hit : bounces.hits) {
      const auto root = first_return(hit.gap, counters);
      if (!root) return false;
      hit.next = *root;
    }
    return true;
  };
  if (!all_found()) {
    detail::read_gaps(bounces, state, 2.0 * bounces.path.span, counters);
    if (!all_found()) return false;  // a flight so much longer than expected is not a chatter's
  }
  const double u = bounces.hits[0].next.at;
  for (const auto &hit : bounces.hits)
    if (std::abs(hit.next.at - u) * bounces.path.power[1] > same_instant) return false;
  bounces.flight = u * bounces.path.span;
  return detail::comes_next(bounces, state, counters);
}

// Moves the state to the impacts found.
template <int D>
void fly(Bounces<D> &bounces, State<D> &state, const Scene &scene, const Instant &then) {
  const double u = bounces.hits[0].next.at;
  move_lanes(state, bounces.path, u, scene);
  state.now = then;
  if (state.mode->any_resonant)
    set_forcing(state, scene);
  else
    turn_forcing(state, scene, bounces.flight);
  tie_decays(state);
  for (const auto &near : bounces.near)
    if (!refresh(state, *near.open))
      state.stops[near.open->stop] = carried(evaluate(near.gap, 0, u), bounces.path.span);
}

// Applies the impacts there (Eqs. 8-11). `closing` is set to the gap speeds before them. False when
// something else follows from them: a mass left at rest, a hold force that is no longer positive.
template <int D>
bool bounce(Bounces<D> &bounces, State<D> &state, const Scene &scene,
            std::vector<double> &closing) {
  const double r = scene.restitution;
  bounces.time += bounces.flight;
  bounces.times.push_back(bounces.time);
  closing.clear();
  bool on = true;
  for (const auto &hit : bounces.hits) {
    closing.push_back(std::min(0.0, hit.next.slope / bounces.path.span));
    apply_impact(state, scene, *hit.open, closing.back());
    const double jump = -(1.0 + r) * closing.back();
    bounces.jumps.push_back(jump);
    bounces.clear_jumps -= jump;
    on = on && state.stops[hit.open->stop].speed > 0.0;
  }
  if (bounces.clear_jumps < 0.0) bounces.clear_until = 0.0;
  if (bounces.clear_until < bounces.time)
    for (const ClosedStop<D> &closed : state.mode->closed)
      on = on && closed.press(state.value, state.slope) > 0.0;
  bounces.flight *= std::max(r, 0x1p-30);
  return on;
}

// Looks along the next flight, and as far ahead as the chatter may last.
template <int D>
void look_on(Bounces<D> &bounces, const State<D> &state, Counters &counters) {
  detail::read_gaps(bounces, state, 1.2 * bounces.flight, counters);
  if (bounces.time + bounces.flight <= bounces.clear_until) return;
  const RestitutionSeries &series = bounces.series.of;
  const double left = 1.5 * bounces.flight * series.flights;
  const double jumps = 1.5 * bounces.latest_jump() * series.restitution * series.flights;
  if (!detail::others_stay_clear(bounces, state, left, jumps)) return;
  bounces.clear_until = bounces.time + left;
  bounces.clear_jumps = jumps;
}

// Brings the stops that have been out of reach up to date.
template <int D>
void refresh_stops(const Bounces<D> &bounces, State<D> &state) {
  for (const OpenStop<D> &open : state.mode->open)
    if (!bounces.hits_stop(open.stop)) refresh(state, open);
}

}  // namespace vibro_impact
