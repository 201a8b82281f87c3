// The first event along one expansion: an impact (of one mass or of several at the same instant), a
// release at a root of the hold force, or the hold force grazing zero without crossing it.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "expansion.hpp"
#include "first_root.hpp"
#include "motion.hpp"

namespace vibro_impact {

enum class Happening { nothing, impact, press, release, force_graze };

// `stops` lists the indices of the stops concerned; several only for simultaneous impacts.
// `press` is a mass at rest at its stop whose first non-zero derivative points into it.
struct FirstEvent {
  Happening kind = Happening::nothing;
  double u = 1.0;
  // For a release: the first derivative of the hold force that is not zero, with respect to u, and
  // its order: 1 at a root, more where a mass at rest waits for motion to reach it along the chain.
  double force_slope = 0.0;
  int force_order = 1;
  std::vector<std::size_t> stops;
};

constexpr int out_of_reach = -1;

// Storage of one flight, reused: no allocation between events.
struct Flight {
  Expansion expansion;
  std::vector<Polynomial> gaps;  // one per open stop of the mode
  Polynomial watched;            // of the one stop looked at
  std::vector<Root> roots;       // the first root of each, `at` > 1 for none
  std::size_t within_reach = 0;  // open stops
  FirstEvent event;
};

// Sets `p` to the gap polynomial, with what is known exactly in place of what rounding left.
template <int D>
void read_gap(const State<D> &state, const OpenStop<D> &open, const Expansion &expansion,
              Polynomial &p, Counters &counters) {
  const StopState &stop = state.stops[open.stop];
  read_along(*state.mode, open.gap, state.value, state.slope, expansion, p, counters);
  if (stop.zeros == 0) {
    p.coefficient[0] = stop.gap;
    p.coefficient[1] = stop.speed * expansion.span;
    return;
  }
  double scaled = stop.leading;
  for (int n = 0; n < stop.zeros; ++n) {
    p.coefficient[static_cast<std::size_t>(n)] = 0.0;
    scaled *= expansion.span / (n + 1);
  }
  p.coefficient[static_cast<std::size_t>(stop.zeros)] = scaled;
}

// A wide gap is known from the lanes with less than ten bits lost to cancellation.
template <int D>
double wide_gap(const OpenStop<D> &open, const Eigen::Array<double, D, 1> &value) {
  return 0x1p-10 * (std::abs(open.gap.offset) + (open.gap.on_value * value).abs().sum());
}

// The gap polynomials of the open stops along `flight.expansion`, which expands `state`. A stop
// that is out of reach needs none: no lane moves faster than |y'| + rate |y|, for y'^2 + lambda y^2
// never grows and lambda <= rate^2. Its order is set to `out_of_reach`.
template <int D>
void read_gaps(const State<D> &state, Flight &flight, Counters &counters) {
  const ContactMode<D> &mode = *state.mode;
  flight.gaps.resize(mode.open.size());
  flight.roots.assign(mode.open.size(), Root{2.0});
  flight.within_reach = 0;
  const Eigen::Array<double, D, 1> reach =
      flight.expansion.span * (state.slope.abs() + mode.rate * state.value.abs());
  for (std::size_t k = 0; k < flight.gaps.size(); ++k) {
    const OpenStop<D> &open = mode.open[k];
    const StopState &stop = state.stops[open.stop];
    if (stop.zeros == 0 && !mode.any_resonant &&
        stop.gap > 2.0 * wide_gap(open, state.value) +
                       (1.0 + 0x1p-9) * (open.gap.on_value.abs() * reach).sum()) {
      flight.gaps[k].order = out_of_reach;
    } else {
      read_gap(state, open, flight.expansion, flight.gaps[k], counters);
      ++flight.within_reach;
    }
  }
}

// Finds the first event in (0, 1] of `flight.expansion`, which expands `state`.
template <int D>
void find_first_event(const State<D> &state, Flight &flight, Counters &counters) {
  const ContactMode<D> &mode = *state.mode;
  FirstEvent &event = flight.event;
  event.kind = Happening::nothing;
  event.u = 1.0;
  event.stops.clear();
  read_gaps(state, flight, counters);
  double limit = 1.0;
  std::size_t hit = 0;
  const auto uncertainty_of = [&](std::size_t k) {
    return uncertainty(flight.gaps[k], state.stops[mode.open[k].stop].zeros, flight.roots[k]);
  };

  for (std::size_t k = 0; k < mode.open.size(); ++k) {
    const OpenStop<D> &open = mode.open[k];
    const StopState &stop = state.stops[open.stop];
    if (flight.gaps[k].order == out_of_reach) {
      ++counters.stops_out_of_reach;
      continue;
    }
    const auto root = first_root(flight.gaps[k], stop.zeros, limit, counters);
    if (!root) continue;
    flight.roots[k] = *root;
    if (root->at < event.u || event.kind == Happening::nothing) {
      event.kind = root->at == 0.0 && stop.speed == 0.0 ? Happening::press : Happening::impact;
      event.u = root->at;
      event.stops.assign(1, open.stop);
      hit = k;
      if (flight.within_reach > 1)
        limit = std::min(1.0, event.u + uncertainty_of(k) + 1e-9 * event.u);
    }
  }
  for (const ClosedStop<D> &closed : mode.closed) {
    Polynomial &force = flight.watched;
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
  if (event.kind != Happening::impact || flight.within_reach == 1) return;
  // Impacts whose times agree within their rounding are one event.
  for (std::size_t k = 0; k < mode.open.size(); ++k)
    if (k != hit && flight.roots[k].at <= 1.0 &&
        flight.roots[k].at - event.u <= uncertainty_of(k) + uncertainty_of(hit))
      event.stops.push_back(mode.open[k].stop);
  std::sort(event.stops.begin(), event.stops.end());  // their order by time is rounding
}

// Moves `state` to u of the expansion: lanes, time, and the carried gaps.
template <int D>
void move_to(State<D> &state, const Flight &flight, double u, const Scene &scene,
             const Clock &clock) {
  const ContactMode<D> &mode = *state.mode;
  if (u == 0.0) return;
  const Expansion &expansion = flight.expansion;
  const bool long_flight = u * expansion.power[1] > 1.0;
  if (mode.any_resonant) {  // the forcing works on these lanes: in closed form
    const State<D> before{{}, nullptr, state.value, state.slope, {}};
    flow(mode, scene, before.value, before.slope, u * expansion.span, state.value, state.slope);
  } else {
    advance(mode, expansion, u, state.value, state.slope);
  }
  tie_decays(state);
  drop_dead_lanes(state);
  state.now = later(state.now, u * expansion.span, clock);
  set_forcing(state, scene);
  for (std::size_t k = 0; k < mode.open.size(); ++k) {
    const OpenStop<D> &open = mode.open[k];
    StopState &stop = state.stops[open.stop];
    const Root &root = flight.roots[k];
    if (root.at == u) {
      stop = {0.0, root.slope / expansion.span, 0, 0.0};
      continue;
    }
    // A wide gap is read off the lanes, so that the carried one cannot drift away from them; after
    // a long flight the carried one has no more digits than the lanes, which are read wherever
    // that cannot close the gap.
    const double gap = open.gap(state.value, state.slope);
    if (flight.gaps[k].order == out_of_reach ||
        gap > (long_flight ? 0x1p-30 : 1.0) * wide_gap(open, state.value)) {
      stop = {gap, (open.gap.on_value * state.slope).sum(), 0, 0.0};
    } else {
      const auto carried = evaluate(flight.gaps[k], stop.zeros, u);
      stop = {std::max(0.0, carried.value), carried.slope / expansion.span, 0, 0.0};
    }
  }
  for (const ClosedStop<D> &closed : mode.closed) state.stops[closed.stop].zeros = 0;
}

}  // namespace vibro_impact
