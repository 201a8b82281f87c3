// The first event along one expansion: an impact (of one mass or of several at the same instant), a
// release at a root of the hold force, or the hold force grazing zero without crossing it.
#pragma once

#include <algorithm>
#include <cmath>

#include "flight.hpp"

namespace vibro_impact {

// The event, when a single stop may change and its gap or hold force crosses zero once, clearly.
template <int D>
bool find_one_crossing(const State<D> &state, const Scene &scene, const Clock &clock,
                       Flight<D> &flight, Counters &counters) {
  const ContactMode<D> &mode = *state.mode;
  if (flight.undecided != 1 || mode.any_resonant) return false;
  std::size_t k = 0;
  while (flight.seen[k].outlook == Outlook::stays_positive) ++k;
  if (flight.seen[k].outlook != Outlook::crosses_once) return false;
  const bool opens = k >= mode.open.size();
  const ClosedStop<D> *closed = opens ? &mode.closed[k - mode.open.size()] : nullptr;
  const Reading<D> &reading = opens ? closed->press : mode.open[k].gap;
  ++counters.crossings_sought;
  Crossing<D> &crossing = flight.crossing.emplace();
  if (!find_crossing(state, reading, flight.seen[k], flight.expansion, scene, clock, crossing,
                     counters)) {
    flight.crossing.reset();
    return false;
  }
  FirstEvent &event = flight.event;
  event.u = crossing.u;
  event.kind = opens ? Happening::release : Happening::impact;
  event.force_slope = crossing.rate * flight.expansion.span;
  event.force_order = 1;
  event.stops.assign(1, opens ? closed->stop : mode.open[k].stop);
  return true;
}

// Finds the first event in (0, 1] of `flight.expansion`, which expands `state`.
template <int D>
void find_first_event(const State<D> &state, const Scene &scene, const Clock &clock,
                      Flight<D> &flight, Counters &counters) {
  const ContactMode<D> &mode = *state.mode;
  FirstEvent &event = flight.event;
  event.kind = Happening::nothing;
  event.u = 1.0;
  event.stops.clear();
  flight.crossing.reset();
  look_ahead(state, flight, counters);
  if (flight.undecided == 0 || find_one_crossing(state, scene, clock, flight, counters)) return;
  double limit = 1.0;
  std::size_t hit = 0;
  flight.gaps.resize(mode.open.size());
  flight.roots.assign(mode.open.size(), Root{2.0});
  const auto uncertainty_of = [&](std::size_t k) {
    return uncertainty(flight.gaps[k], state.stops[mode.open[k].stop].zeros, flight.roots[k]);
  };

  for (std::size_t k = 0; k < mode.open.size(); ++k) {
    const OpenStop<D> &open = mode.open[k];
    const StopState &stop = state.stops[open.stop];
    if (flight.seen[k].outlook == Outlook::stays_positive) continue;
    read_gap(state, open, flight.expansion, flight.gaps[k], counters);
    const auto root = first_root(flight.gaps[k], stop.zeros, limit, counters);
    if (!root) continue;
    flight.roots[k] = *root;
    if (root->at < event.u || event.kind == Happening::nothing) {
      event.kind = root->at == 0.0 && stop.speed == 0.0 ? Happening::press : Happening::impact;
      event.u = root->at;
      event.stops.assign(1, open.stop);
      hit = k;
      if (flight.undecided > 1) limit = std::min(1.0, event.u + uncertainty_of(k) + 1e-9 * event.u);
    }
  }
  for (std::size_t k = 0; k < mode.closed.size(); ++k) {
    const ClosedStop<D> &closed = mode.closed[k];
    Polynomial &force = flight.watched;
    if (flight.seen[mode.open.size() + k].outlook == Outlook::stays_positive) continue;
    read_along(mode, closed.press, state.value, state.slope, flight.expansion, force, counters);
    const int zeros = state.stops[closed.stop].zeros;
    const auto root = first_root(force, zeros, event.u, counters);
    if (!root || (event.kind != Happening::nothing && root->at >= event.u)) continue;
    double slope = evaluate(force, 0, root->at).slope;
    int order = 1;
    // Known to be zero now, it falls: with its first derivative that is not zero.
    const bool falls = root->at == 0.0 && zeros == 1;
    if (falls) {
      while (order < force.order && force.coefficient[static_cast<std::size_t>(order)] == 0.0)
        ++order;
      slope = std::tgamma(order + 1.0) * force.coefficient[static_cast<std::size_t>(order)];
    }
    event.kind = falls || slope < 0.0 ? Happening::release : Happening::force_graze;
    event.u = root->at;
    event.force_slope = slope;
    event.force_order = order;
    event.stops.assign(1, closed.stop);
  }
  if (event.kind != Happening::impact || flight.undecided == 1) return;
  // Impacts whose times agree within their rounding are one event.
  for (std::size_t k = 0; k < mode.open.size(); ++k)
    if (k != hit && flight.roots[k].at <= 1.0 &&
        flight.roots[k].at - event.u <= uncertainty_of(k) + uncertainty_of(hit))
      event.stops.push_back(mode.open[k].stop);
  std::sort(event.stops.begin(), event.stops.end());  // their order by time is rounding
}

}  // namespace vibro_impact
