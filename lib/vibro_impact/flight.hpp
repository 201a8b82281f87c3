// One flight: along an expansion up to its first event, or to its end.
#pragma once

#include <optional>
#include <vector>

#include "crossing.hpp"
#include "reach.hpp"

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

// Storage of one flight, reused: no allocation between events.
template <int D>
struct Flight {
  Expansion expansion;
  std::vector<Survey> seen;             // of the open stops of the mode, then of the closed ones
  std::size_t undecided = 0;            // how many of them are not certain to stay as they are
  std::vector<Polynomial> gaps;         // one per open stop
  Polynomial watched;                   // of the one closed stop looked at
  std::vector<Root> roots;              // the first root of each open stop, `at` > 1 for none
  std::optional<Crossing<D>> crossing;  // the lanes at the event, where it was found on them
  FirstEvent event;
};

// Sets `p` to the gap polynomial, with what is known exactly in place of what rounding left.
template <int D>
void read_gap(const ContactMode<D> &mode, const OpenStop<D> &open, const StopState &stop,
              const Eigen::Array<double, D, 1> &value, const Eigen::Array<double, D, 1> &slope,
              const Expansion &expansion, Polynomial &p, Counters &counters) {
  read_along(mode, open.gap, value, slope, expansion, p, counters);
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

template <int D>
void read_gap(const State<D> &state, const OpenStop<D> &open, const Expansion &expansion,
              Polynomial &p, Counters &counters) {
  read_gap(*state.mode, open, state.stops[open.stop], state.value, state.slope, expansion, p,
           counters);
}

// Looks at the stops along `flight.expansion`, which expands `state`: which of them are certain to
// stay as they are. A stop that is out of reach does, at the price of one comparison. The others
// are surveyed, except where a mass that has just left its stop is expected back soon.
template <int D>
void look_ahead(const State<D> &state, Flight<D> &flight, Counters &counters) {
  const ContactMode<D> &mode = *state.mode;
  const Expansion &expansion = flight.expansion;
  const bool whole = expansion.power[1] > 0.999 * max_reach;
  flight.seen.resize(mode.open.size() + mode.closed.size());
  flight.undecided = 0;
  auto seen = flight.seen.begin();
  const auto enter = [&](const Survey &found) {
    *seen++ = found;
    if (found.outlook == Outlook::stays_positive)
      ++counters.roots_dismissed;
    else
      ++flight.undecided;
  };
  const auto look = [&](const Reading<D> &reading, std::size_t known) {
    Survey found = survey(mode, reading, state.value, state.slope, expansion, known, counters);
    if (!whole && found.outlook == Outlook::crosses_once) found.outlook = Outlook::undecided;
    enter(found);
  };
  const Eigen::Array<double, D, 1> speeds =
      speed_bounds(mode, state.value, state.slope, expansion.span);
  for (const OpenStop<D> &open : mode.open) {
    const StopState &stop = state.stops[open.stop];
    const auto zeros = static_cast<std::size_t>(stop.zeros);
    if (zeros == 0 && out_of_reach(stop.gap, open, state.value, speeds, expansion.span)) {
      *seen++ = {Outlook::stays_positive};
      ++counters.stops_out_of_reach;
    } else if (zeros == 0 ? stop.gap > 0.0 : stop.leading > 0.0 && whole) {
      look(open.gap, zeros + 1);
    } else {
      enter({});
    }
  }
  for (const ClosedStop<D> &closed : mode.closed)
    if (state.stops[closed.stop].zeros == 0)
      look(closed.press, 0);
    else
      enter({});
}

// Moves the lanes to u of the expansion, those of the forcing excepted.
template <int D>
void move_lanes(State<D> &state, const Expansion &expansion, double u, const Scene &scene) {
  if (state.mode->any_resonant) {  // the forcing works on these lanes: in closed form
    const typename State<D>::Lanes value = state.value, slope = state.slope;
    flow(*state.mode, scene, value, slope, u * expansion.span, state.value, state.slope);
  } else {
    advance(*state.mode, expansion, u, state.value, state.slope);
  }
}

// Moves `state` to u of the expansion: lanes, time, and the carried gaps.
template <int D>
void move_to(State<D> &state, Flight<D> &flight, double u, const Scene &scene, const Clock &clock,
             Counters &counters) {
  const ContactMode<D> &mode = *state.mode;
  if (u == 0.0) return;
  const Expansion &expansion = flight.expansion;
  const bool long_flight = u * expansion.power[1] > 1.0;
  const typename State<D>::Lanes value = state.value, slope = state.slope;
  if (flight.crossing) {
    state.value = flight.crossing->value;
    state.slope = flight.crossing->slope;
  } else {
    move_lanes(state, expansion, u, scene);
  }
  state.now = later(state.now, u * expansion.span, clock);
  if (!flight.crossing) set_forcing(state, scene);
  tie_decays(state);
  drop_dead_lanes(state);
  for (std::size_t k = 0; k < mode.open.size(); ++k) {
    const OpenStop<D> &open = mode.open[k];
    StopState &stop = state.stops[open.stop];
    const bool stayed_open = flight.seen[k].outlook == Outlook::stays_positive;
    if (!stayed_open && flight.crossing) {
      stop = {0.0, flight.crossing->rate, 0, 0.0};
      continue;
    }
    if (!stayed_open && flight.roots[k].at == u) {
      stop = {0.0, flight.roots[k].slope / expansion.span, 0, 0.0};
      continue;
    }
    // Within the rounding of the time a mass leaving from rest is still leaving from rest; the
    // acceleration read off the lanes is rounding, and would bring it back.
    if (stop.zeros >= 2 && u * expansion.power[1] < 0x1p-50) continue;
    // A wide gap is read off the lanes, so that the carried one cannot drift away from them; after
    // a long flight the carried one has no more digits than the lanes, which are read wherever
    // that cannot close the gap.
    if (refresh(state, open, long_flight ? 0x1p-30 : 1.0)) continue;
    if (stayed_open) {
      flight.gaps.resize(mode.open.size());
      read_gap(mode, open, stop, value, slope, expansion, flight.gaps[k], counters);
    }
    stop = carried(evaluate(flight.gaps[k], stop.zeros, u), expansion.span);
  }
  for (const ClosedStop<D> &closed : mode.closed) state.stops[closed.stop].zeros = 0;
}

}  // namespace vibro_impact
