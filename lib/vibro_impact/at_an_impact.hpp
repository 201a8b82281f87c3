// The impacts of one event: the impact law, what follows from it (sticking, a neighbour's release),
// and the chatter it may belong to.
#pragma once

#include "complete_chatter.hpp"

namespace vibro_impact::detail {

template <int D>
void handle_impact(Run<D> &run) {
  const std::vector<std::size_t> &stops = run.flight.event.stops;
  run.closing.clear();
  for (std::size_t stop : stops) {
    run.closing.push_back(std::min(0.0, run.state.stops[stop].speed));
    apply_impact(run.state, run.scene, open_stop(run.state, stop), run.closing.back());
  }
  const ContactMode<D> *before = run.state.mode;
  record_impacts(run, stops);
  settle_after(run, stops);
  const double since_last = run.since_impact;
  run.since_impact = 0.0;
  run.flight_guess = std::numeric_limits<double>::infinity();
  // Chatter: not where r = 0 (one impact stops the mass) and not where r = 1 (it never ends).
  const double r = run.scene.restitution;
  if (run.state.mode == before && r > 0.0 && r < 1.0) follow_chatter(run, stops, since_last);
}

}  // namespace vibro_impact::detail
