#include "follow.hpp"

#include <algorithm>
#include <cmath>

namespace vibro_impact::branches {

namespace {

// Adds an event of an item at an instant to a list.
void add_event(const Scene &scene, const Item &item, const AtItem &seen, const Instant &instant,
               std::vector<Event> &events) {
  const Stop &stop = scene.stops[static_cast<size_t>(item.stop)];
  Event event{.stop = item.stop + 1,
              .mass = stop.mass,
              .side = stop.side,
              .instant = instant,
              .time = time_of(instant, Clock(scene.omega)),
              .held = Held(scene.mass.size(), 0)};
  for (size_t i = 0; i < event.held.size(); ++i)
    if (const int held = seen.after.held[i]; held >= 0)
      event.held[i] = static_cast<signed char>(scene.stops[static_cast<size_t>(held)].side);
  if (releases(item.what)) {
    event.kind = EventKind::release;
    event.by_a_jump = item.what == Happening::jump;
    events.push_back(event);
    return;
  }
  Event impact = event;
  if (item.what == Happening::hold) impact.held[static_cast<size_t>(stop.mass - 1)] = 0;
  impact.velocity_before = sign(stop.side) * seen.speed;
  impact.velocity_after = -sign(stop.side) * law_of(scene, stop).after(std::max(seen.speed, 0.0));
  const auto last = std::find_if(events.rbegin(), events.rend(),
                                 [&](const Event &e) { return e.stop == impact.stop; });
  if (last != events.rend() && last->kind == EventKind::impact &&
      std::abs(impact.velocity_before) < std::abs(last->velocity_before))
    impact.falling = last->falling + 1;
  events.push_back(impact);
  if (item.what != Happening::hold) return;
  event.kind = EventKind::stick;
  events.push_back(event);
}

// The events of one period from the state in the longest flight on.
std::vector<Event> events_of(const Problem &problem, const Scene &scene, const Place &place,
                             const Instant &start) {
  const Clock clock(scene.omega);
  const auto times = place.u.tail(index(place.sequence.items.size()));
  Eigen::Index longest = 0;
  double time = 0.5 * times.maxCoeff(&longest);
  std::vector<Event> events;
  const size_t count = place.sequence.items.size();
  for (size_t k = 1; k <= count; ++k) {
    const size_t at = (static_cast<size_t>(longest) + k) % count;
    const Item &item = place.sequence.items[at];
    if (hits(item.what) || releases(item.what))
      add_event(scene, item, place.seen.items[at], later(start, std::max(time, 0.0), clock),
                events);
    time += place.u(problem.time_at(at));
  }
  return events;
}

}  // namespace

OrbitPoint orbit_point_of(const Problem &problem, const Point &point) {
  const Place &place = point.place;
  const Scene scene = scene_at(problem, place.parameter());
  OrbitPoint result{.parameter = place.parameter(), .error = point.error, .kind = point.kind};
  PeriodicOrbit &orbit = result.orbit;
  orbit.state = quiet_state(problem, place.sequence, place.u, place.seen);
  orbit.multipliers = place.multipliers;
  if (place.multipliers.empty())
    orbit.multipliers = Smooth<Multipliers>::none("an impact has lost its speed at a graze");
  orbit.converged = true;
  orbit.why_not = point.why_lost;
  const Vector values = evaluate(problem, place.sequence, place.u, nullptr, false).values;
  const Eigen::Index n = index(problem.masses());
  orbit.residuals = {values.segment(values.size() - 1 - 2 * n, n).lpNorm<Eigen::Infinity>()};
  orbit.events = events_of(problem, scene, place, orbit.state.instant);
  result.counts = counts_of(scene, orbit.events, place.sequence.periods, orbit.state.held);
  return result;
}

}  // namespace vibro_impact::branches
