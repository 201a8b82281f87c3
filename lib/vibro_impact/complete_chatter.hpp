// Complete chatter within a run: when the limit of the sequence may be taken, and taking it.
//
// A chatter that is over within the rounding of the time is at rest, whatever else happens within
// that rounding: so chatters of several masses that end together do not keep each other alive.
#pragma once

#include <optional>

#include "at_a_stop.hpp"

namespace vibro_impact::detail {

// True when nothing else can happen within tau: every other gap and hold force keeps clear of zero
// by more than the impacts left in the chatter (total impulse per mass `impulse`) can move it.
template <int D>
bool clear_until(Run<D> &run, double tau, double impulse) {
  const ContactMode<D> &mode = *run.state.mode;
  expand(mode, run.state.value, run.state.slope, tau, run.flight.expansion, run.counters);
  const double stiffest = mode.lambda.maxCoeff(), most_damped = mode.kappa.maxCoeff();
  const double gap_margin = tau * tau * (most_damped + stiffest * tau) * impulse;
  const double link = *std::max_element(run.scene.stiffness.begin(), run.scene.stiffness.end());
  const double force_margin = link * (run.scene.beta + tau) * impulse;
  const auto one = [](int) { return 1.0; };
  for (const OpenStop<D> &open : mode.open) {
    if (std::find(run.chatter.stops.begin(), run.chatter.stops.end(), open.stop) !=
        run.chatter.stops.end())
      continue;
    const StopState &stop = run.state.stops[open.stop];
    if (stop.zeros != 0) return false;
    read_gap(run.state, open, run.flight.expansion, run.flight.watched, run.counters);
    if (lower_bound(run.flight.watched, 0, one) <= gap_margin) return false;
  }
  for (const ClosedStop<D> &closed : mode.closed) {
    read_along(mode, closed.press, run.state.value, run.state.slope, run.flight.expansion,
               run.flight.watched, run.counters);
    if (lower_bound(run.flight.watched, 0, one) <= force_margin) return false;
  }
  return true;
}

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

// Carries a complete chatter to its limit when that is certain; true when it did. `hit` are the
// stops of the impacts just applied, `flight` the longest flight ahead of them.
template <int D>
bool take_chatter_limit(Run<D> &run, const std::vector<std::size_t> &hit, double flight,
                        bool new_node, double tau_at_most) {
  const double r = run.scene.restitution, fastest = run.state.mode->fastest;
  const bool over = flight / (1.0 - r) * fastest < same_instant;
  // Those that are over come to rest, whatever others hit at the same instant and go on.
  const std::vector<std::size_t> stops = over ? hit : run.chatter.stops;
  const double speed = run.state.stops[stops.front()].speed;
  // To leading order in the speed.
  const double tail = (stops == hit ? flight : longest_flight(run, stops)) / (1.0 - r);
  if (tail > 2.0 * tau_at_most) return false;

  std::optional<ChatterLimit<D>> limit;
  if (tail * fastest < 1e-9) {
    // What is left is below rounding: the prediction is the limit, with an error of order tail^3.
    ChatterNode<D> &predicted = run.chatter.nodes[run.chatter.size];
    predict_limit(run.state, stops, run.scene, predicted);
    if (!over && !(std::abs(predicted.correction) * fastest < 1e-15)) return false;
    limit.emplace(ChatterLimit<D>{predicted.tail, run.state, 0.0});
    limit->state.value = predicted.value;
    limit->state.slope = predicted.slope;
    limit->state.stops = predicted.stops;
  } else if (new_node && speed < run.options.resolve_chatter) {
    limit = extrapolate(run.chatter, run.state, run.options.chatter_tolerance);
  }
  if (!limit || !(limit->tau < tau_at_most)) return false;
  if (!over && !clear_until(run, limit->tau, (1.0 + r) / (1.0 - r) * speed)) return false;
  for (const OpenStop<D> &open : run.state.mode->open) {
    double &gap = limit->state.stops[open.stop].gap;
    gap = std::max(0.0, gap);
  }
  limit->state.now = later(run.state.now, limit->tau, run.clock);
  set_forcing(limit->state, run.scene);
  for (std::size_t stop : stops)
    if (!(open_stop(run.state, stop).press(limit->state.value, limit->state.slope) > 0.0))
      return false;  // a border orbit or beyond: the chatter is not complete

  sample_flight(run, 0.0);
  run.state = std::move(limit->state);
  for (std::size_t stop : stops) run.state.stops[stop] = {};
  for (std::size_t stop : stops) stick_at(run, stop);
  ++run.counters.chatter_limits;
  return true;
}

}  // namespace vibro_impact::detail
