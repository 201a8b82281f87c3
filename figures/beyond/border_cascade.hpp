// The border orbits unfolded: beyond the border the chatter has finitely many impacts, one more
// each time the distance to the border shrinks by the same factor (figures/beyond/README.md, The
// border orbit unfolded).
#pragma once

#include <cmath>
#include <optional>
#include <stdexcept>
#include <vector>

#include "curve_starts.hpp"

namespace vibro_impact::figures {

// The factor: per impact the difference from the border chatter grows by `escape`, and after n
// impacts a distance d is used up, d escape^n of order 1. Of the restitution alone.
inline double cascade_factor(double restitution) {
  return 1.0 / border_chatter(restitution).escape;
}

// How many impacts the chatter of a border orbit has at a distance beyond it, in omega.
struct UnfoldedChatter {
  double distance = 0.0;
  int impacts = 0;
};

// The chatter of a mass that begins or, with `at_end`, ends nearest to a time; nothing where it has
// none.
inline std::optional<Chatter> chatter_near(const std::vector<Event> &events, int mass, double time,
                                           bool at_end) {
  std::optional<Chatter> nearest;
  const auto away = [&](const Chatter &chatter) {
    const std::size_t impact = at_end ? chatter.impacts.back() : chatter.impacts.front();
    return std::abs(events[impact].time - time);
  };
  for (const Chatter &chatter : chatters_of(events))
    if (events[chatter.impacts.front()].mass == mass &&
        (!nearest || away(chatter) < away(*nearest)))
      nearest = chatter;
  return nearest;
}

// On the orbit followed away from the border, to where the chatter does not complete, in steps of a
// tenth of a decade from 1e-10 to `farthest`. Places where it is not found are passed over.
inline std::vector<UnfoldedChatter> unfolded(const CurveStart &start, double farthest) {
  const StartedCurve border = started(start);
  const int periods = border.curve.periods;
  MotionState state = border.point.state;
  const auto events_in = [&](const Scene &scene) {  // every impact resolved
    EventRecorder told{.from = time_of(state.instant, Clock(scene.omega))};
    stroboscopic_map(scene, state, periods, {.resolve_chatter = 0.0}, told);
    return told.events;
  };
  const std::vector<Event> on_border = events_in(border.curve.at(border.point.at));
  const double section = state.instant.phase;
  const auto bordering = chatter_near(on_border, start.mass, section + border.point.time, true);
  if (!bordering) throw std::runtime_error(start.name + ": no chatter on the border orbit");
  double begin = on_border[bordering->impacts.front()].time - section;
  NewtonOptions to_rounding;
  to_rounding.tolerance = 3e-15;  // the default, 1e-13, is 1e-3 of the smallest distances
  std::vector<UnfoldedChatter> counts;
  for (double distance = 1e-10; distance < 1.01 * farthest; distance *= std::pow(10.0, 0.1)) {
    const Scene beyond =
        border.curve.at({border.point.at.x - start.whole.x * distance, border.point.at.y});
    const PeriodicOrbit orbit = find_periodic_orbit(beyond, state, periods, to_rounding);
    if (!orbit.converged) continue;
    state = orbit.state;
    const std::vector<Event> events = events_in(beyond);
    const auto chatter = chatter_near(events, start.mass, state.instant.phase + begin, false);
    if (!chatter || chatter->complete) continue;
    begin = events[chatter->impacts.front()].time - state.instant.phase;
    counts.push_back({distance, static_cast<int>(chatter->impacts.size())});
  }
  return counts;
}

}  // namespace vibro_impact::figures
