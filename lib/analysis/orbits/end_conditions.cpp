#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "curve_kinds.hpp"
#include "motion_state.hpp"
#include "vibro_impact/analysis/curve_end.hpp"
#include "vibro_impact/analysis/multi_sliding.hpp"

namespace vibro_impact {

namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

// The orbit of a point of the curve, or where the motion is another on it, beside it on the side
// where what happens is whole.
struct Beside {
  CurvePoint point;
  Scene scene;
  MotionState state;
  std::vector<std::complex<double>> multipliers = {};
  std::vector<Event> events = {};  // of a border orbit without the impacts of the chatter
  double limit = unknown, press_rate = unknown;  // of a border orbit: as in OnBorder
  double apart = unknown;                        // the least time between impacts of two masses
};

std::optional<Beside> beside(const BifurcationCurve &curve, const CurvePoint &point) {
  constexpr double away = 1e-13;
  const double length = std::hypot(point.gradient.x, point.gradient.y);
  Beside found{point, curve.at(point.at), point.state};
  if (curve.what == Bifurcation::border_orbit) {
    const auto on = on_border(curve, point);
    if (!on) return std::nullopt;
    found.multipliers = on->multipliers;
    found.events = on->events;
    found.limit = on->end;
    found.press_rate = on->press_rate;
    found.apart = on->apart;
    // Where the chatter just completes, so that it leaves no gap.
    found.scene = curve.at(moved(point.at, point.gradient, away / length));
    found.state.instant.phase =
        same_angle(point.state.instant.phase, curve.at(point.at), found.scene);
    hold_at_stops(found.scene, found.state);
    return found;
  }
  if (of_impacts(curve.what)) {
    found.state = at_quiet_phase(found.scene, point.state);
  } else {
    found.scene = curve.at(moved(point.at, point.gradient, away / length));
    const auto orbit =
        orbit_in(found.scene, curve.at(point.at), point.state, curve.periods, RunOptions{});
    if (!orbit) return std::nullopt;
    found.state = orbit->state;
    found.multipliers = orbit->multipliers;
  }
  EventRecorder recorder;
  recorder.from = -std::numeric_limits<double>::infinity();
  stroboscopic_map(found.scene, found.state, curve.periods, {}, recorder);
  found.events = std::move(recorder.events);
  found.apart = time_apart(found.events);
  return found;
}

// The slowest impact of a mass outside complete chatters.
double slowest_impact(const Beside &at, int mass) {
  double slowest = std::numeric_limits<double>::infinity();
  bool completes = false;
  for (std::size_t k = at.events.size(); k-- > 0;) {
    const Event &event = at.events[k];
    if (event.mass != mass) continue;
    if (event.kind != EventKind::impact) {
      completes = event.kind == EventKind::stick;
      continue;
    }
    if (!completes) slowest = std::min(slowest, std::abs(event.velocity_before));
    if (event.falling == 0) completes = false;
  }
  return slowest;
}

std::string grazing_of(int mass) {
  return std::string("grazing of mass ").append(std::to_string(mass));
}

double below_fold(const Beside &at) {
  double largest = -std::numeric_limits<double>::infinity();
  for (const auto &multiplier : at.multipliers)
    if (multiplier.imag() == 0.0) largest = std::max(largest, multiplier.real());
  return 1.0 - largest;
}

// The time from the latest event of this kind at the stop to the least force, or to the next one.
double time_to(const Beside &at, std::size_t stop, EventKind kind) {
  const auto least = where_pressing_force_is_least(at.scene, at.state, at.scene.stops[stop]);
  if (!least) return unknown;
  const Clock clock(at.scene.omega);
  double nearest = std::numeric_limits<double>::infinity();
  for (const Event &event : at.events) {
    if (event.stop != stop || event.kind != kind) continue;
    double apart = elapsed(event.instant, least->at.instant, clock);
    if (kind == EventKind::release) apart = -apart;
    apart -= clock.period * std::floor(apart / clock.period);
    nearest = std::min(nearest, apart);
  }
  return nearest;
}

// The square of the shortest sticking phase of a mass, from event to event: where it is zero, its
// chatter does not complete. One that goes on at the section is not counted.
double shortest_phase(const Beside &at, int mass) {
  double shortest = std::numeric_limits<double>::infinity(), begun = unknown;
  for (const Event &event : at.events) {
    if (event.mass != mass || event.kind == EventKind::impact) continue;
    if (event.kind == EventKind::stick) begun = event.time;
    if (event.kind == EventKind::release) shortest = std::fmin(shortest, event.time - begun);
  }
  return shortest * shortest;
}

// The time between the limit of the chatter and the nearest impact of another mass, of this period
// or the next.
double time_to_impact(const Beside &at, int mass) {
  const double period = Clock(at.scene.omega).period;
  double nearest = std::numeric_limits<double>::infinity();
  for (const Event &event : at.events)
    if (event.kind == EventKind::impact && event.mass == mass)
      nearest = std::min(nearest, std::abs(std::remainder(
                                      event.time - at.state.instant.phase - at.limit, period)));
  return nearest;
}

}  // namespace

EndConditions end_conditions(const BifurcationCurve &curve) {
  using Value = std::function<double(const Beside &)>;
  EndConditions conditions;
  std::vector<Value> values;
  const auto add = [&](std::string name, Value value) {
    conditions.names.push_back(std::move(name));
    values.push_back(std::move(value));
  };
  const std::vector<Stop> &stops = curve.scene.stops;
  for (int mass = 1; mass <= curve.scene.masses(); ++mass)
    add(grazing_of(mass), [mass, family = of_impacts(curve.what)](const Beside &at) {
      const double slowest = slowest_impact(at, mass), speed = at.point.speed;
      return family && std::abs(slowest - speed) < 0.1 * speed ? speed : slowest;
    });
  for (int mass = 1; mass <= curve.scene.masses(); ++mass)
    add(std::string("border orbit of mass ").append(std::to_string(mass)),
        [mass](const Beside &at) { return shortest_phase(at, mass); });
  for (std::size_t stop = 0; stop < stops.size(); ++stop)
    if (curve.what != Bifurcation::grazing)
      add(grazing_of(stops[stop].mass), [stop](const Beside &at) {
        const double gap = least_gap(at.scene, at.state, at.scene.stops[stop]).value_or(unknown);
        return gap < 1e-13 ? unknown : gap;  // where it has just been in contact
      });
  if (!of_impacts(curve.what)) add("fold", below_fold);
  const std::size_t stop = curve.stop;
  switch (curve.what) {
    case Bifurcation::fold:
      add("cusp", [](const Beside &at) { return std::abs(at.point.gradient.x); });
      break;
    case Bifurcation::multi_sliding:
      add("beginning of the phase",
          [stop](const Beside &at) { return time_to(at, stop, EventKind::stick); });
      add("end of the phase", [stop](const Beside &at) {
        const double time = time_to(at, stop, EventKind::release);
        return time * time;
      });
      break;
    case Bifurcation::border_orbit:
      for (int mass = 1; mass <= curve.scene.masses(); ++mass)
        if (mass != stops[stop].mass)
          add(std::string("impact of mass ").append(std::to_string(mass)).append(" at the limit"),
              [mass](const Beside &at) { return time_to_impact(at, mass); });
      add("force without rate", [](const Beside &at) { return -at.press_rate; });
      add("no restitution", [stop](const Beside &at) {
        return std::sqrt(law_of(at.scene, at.scene.stops[stop]).at_rest());
      });
      break;
    default:
      break;
  }
  // Mostly too slight a corner to be seen.
  add("double impact", [](const Beside &at) { return at.apart; });
  conditions.passable = 1;
  conditions.values = [curve, values](const CurvePoint &point) {
    const auto at = beside(curve, point);
    std::vector<double> now;
    for (const Value &value : values) now.push_back(at ? value(*at) : unknown);
    return now;
  };
  return conditions;
}

}  // namespace vibro_impact
