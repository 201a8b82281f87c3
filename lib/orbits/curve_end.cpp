#include "vibro_impact/curve_end.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "chain/require.hpp"
#include "curve_kinds.hpp"
#include "units.hpp"
#include "vibro_impact/multi_sliding.hpp"

namespace vibro_impact {

namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

// The orbit beside a point of the curve, on the side where what happens is whole.
struct Beside {
  Scene scene;
  PeriodicOrbit orbit;
  std::vector<Event> events = {};
};

std::optional<Beside> beside(const BifurcationCurve &curve, const CurvePoint &point) {
  constexpr double away = 1e-9;
  const bool on_it = of_impacts(curve.what);
  const double length = std::hypot(point.gradient.x, point.gradient.y);
  Beside found{
      on_it ? curve.at(point.at) : curve.at(moved(point.at, point.gradient, away / length)), {}};
  if (on_it) {
    found.orbit.state = at_quiet_phase(found.scene, point.state);
  } else {
    const auto orbit =
        orbit_in(found.scene, curve.at(point.at), point.state, curve.periods, RunOptions{});
    if (!orbit) return std::nullopt;
    found.orbit = *orbit;
  }
  EventRecorder recorder;
  recorder.from = -std::numeric_limits<double>::infinity();
  stroboscopic_map(found.scene, found.orbit.state, curve.periods, {}, recorder);
  found.events = std::move(recorder.events);
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
  for (const auto &multiplier : at.orbit.multipliers)
    if (multiplier.imag() == 0.0) largest = std::max(largest, multiplier.real());
  return 1.0 - largest;
}

// The time from the latest event of this kind at the stop to the least force, or to the next one.
double time_to(const Beside &at, std::size_t stop, EventKind kind) {
  const auto least = where_pressing_force_is_least(at.scene, at.orbit.state, at.scene.stops[stop]);
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

struct Node {
  PlanePoint at;
  double value;
};

// The point as a polynomial in the value through the last `count` nodes, at zero.
PlanePoint at_zero(const std::vector<Node> &nodes, std::size_t count) {
  const PlanePoint origin = nodes.back().at;
  PlanePoint sum = origin;
  for (std::size_t i = nodes.size() - count; i < nodes.size(); ++i) {
    double weight = 1.0;
    for (std::size_t j = nodes.size() - count; j < nodes.size(); ++j)
      if (j != i) weight *= nodes[j].value / (nodes[j].value - nodes[i].value);
    sum.x += weight * (nodes[i].at.x - origin.x);
    sum.y += weight * (nodes[i].at.y - origin.y);
  }
  return sum;
}

// The values at the last points from which it falls, five at most; a few at the end, where it may
// be past zero or another motion, are left out. And the number of the last point that counts.
std::pair<std::vector<Node>, std::size_t> falling_nodes(const EndCondition &condition,
                                                        const std::vector<CurvePoint> &points) {
  std::vector<Node> backwards;
  std::size_t end = 0;
  for (std::size_t k = points.size(); k-- > 0 && k + 8 > points.size() && backwards.size() < 5;) {
    const double value = condition.value(points[k]);
    const bool usable = value > 0.0 && value < std::numeric_limits<double>::infinity();
    if (!usable || (!backwards.empty() && value <= backwards.back().value)) {
      if (backwards.size() >= 3) break;
      backwards.clear();
    }
    if (!usable) continue;
    if (backwards.empty()) end = k;
    backwards.push_back({points[k].at, value});
  }
  return {{backwards.rbegin(), backwards.rend()}, end};
}

}  // namespace

std::vector<EndCondition> end_conditions(const BifurcationCurve &curve) {
  std::vector<EndCondition> conditions;
  const auto add = [&](std::string name, auto value) {
    conditions.push_back({std::move(name), [curve, value](const CurvePoint &point) {
                            const auto at = beside(curve, point);
                            return at ? value(*at) : unknown;
                          }});
  };
  for (int mass = 1; mass <= curve.scene.masses(); ++mass)
    add(grazing_of(mass), [mass](const Beside &at) { return slowest_impact(at, mass); });
  for (std::size_t stop = 0; stop < curve.scene.stops.size(); ++stop)
    if (curve.what != Bifurcation::grazing)
      add(grazing_of(curve.scene.stops[stop].mass), [stop](const Beside &at) {
        return least_gap(at.scene, at.orbit.state, at.scene.stops[stop]).value_or(unknown);
      });
  if (curve.what == Bifurcation::fold)
    conditions.push_back(
        {"cusp", [](const CurvePoint &point) { return std::abs(point.gradient.x); }});
  if (!of_impacts(curve.what)) add("fold", below_fold);
  if (curve.what != Bifurcation::multi_sliding) return conditions;
  const std::size_t stop = curve.stop;
  add("beginning of the phase",
      [stop](const Beside &at) { return time_to(at, stop, EventKind::stick); });
  add("end of the phase", [stop](const Beside &at) {
    const double time = time_to(at, stop, EventKind::release);
    return time * time;
  });
  return conditions;
}

std::optional<LocatedEnd> end_of(const Corrector &corrector,
                                 const std::vector<EndCondition> &conditions,
                                 const std::vector<CurvePoint> &points, const PlaneBox &box) {
  require(points.size() >= 2, "points: ", points.size(), " given, an end needs 2");
  const Units units(box);
  std::vector<Node> nodes;
  CurvePoint last;
  const EndCondition *zero_there = nullptr;
  double nearest = std::numeric_limits<double>::infinity();
  for (const EndCondition &condition : conditions) {
    const auto [falling, end] = falling_nodes(condition, points);
    if (falling.size() < 3) continue;
    const double ahead = units.distance(at_zero(falling, falling.size()), points[end].at);
    // Where a speed and a gap are zero together the speed: the gap may be its square.
    const bool again = zero_there && zero_there->name == condition.name;
    if (!(ahead < (again ? 0.02 : 1.0) * nearest)) continue;
    nearest = ahead;
    nodes = falling;
    last = points[end];
    zero_there = &condition;
  }
  if (!zero_there) return std::nullopt;
  LocatedEnd end{zero_there->name, {}, std::numeric_limits<double>::infinity(), 0.0};
  for (int step = 0; step < 20 && !(end.error < 1e-10); ++step) {
    const std::size_t count = std::min<std::size_t>(5, nodes.size());
    const PlanePoint at = at_zero(nodes, count);
    const double error = units.distance(at, at_zero(nodes, count - 1));
    if (error < end.error) end = {end.condition, at, error, nodes.back().value};
    std::optional<CurvePoint> next;
    double value = unknown;
    for (double part = 0.75; part > 0.15 && !next; part /= 2.0) {
      const PlanePoint guess{last.at.x + part * (at.x - last.at.x),
                             last.at.y + part * (at.y - last.at.y)};
      if (!inside(box, guess)) break;
      next = corrector(guess, units.across(last), last);
      if (next && units.distance(next->at, guess) > 0.5 * units.distance(guess, last.at))
        next.reset();
      if (next) value = zero_there->value(*next);
      if (!(value > 0.0 && value < nodes.back().value)) next.reset();
    }
    if (!next) break;
    last = *next;
    nodes.push_back({last.at, value});
  }
  if (!(end.error < 1e-5)) return std::nullopt;
  return end;
}

}  // namespace vibro_impact
