#include <algorithm>
#include <cmath>

#include "analysis/orbits/motion.hpp"
#include "sequence.hpp"
#include "simulation/for_analysis.hpp"
#include "tolerances.hpp"
#include "vibro_impact/analysis/parameter.hpp"

namespace vibro_impact::branches {

namespace {

// An item of the sequence, and the knot of the motion that it is.
struct ItemOfRun {
  Item item;
  const Knot *knot;
};

// The items of a motion: the impact before a stick holds the mass. Nothing if a stick has none.
std::optional<std::vector<ItemOfRun>> items_of(const Motion &motion) {
  std::vector<ItemOfRun> items;
  for (const Knot &knot : motion.knots) {
    if (!knot.event) continue;
    const Event &event = *knot.event;
    const int stop = event.stop - 1;
    if (event.kind == EventKind::impact) items.push_back({{Happening::impact, stop}, &knot});
    if (event.kind == EventKind::release)
      items.push_back({{event.by_a_jump ? Happening::jump : Happening::release, stop}, &knot});
    if (event.kind != EventKind::stick) continue;
    const auto last = std::find_if(items.rbegin(), items.rend(),
                                   [stop](const ItemOfRun &i) { return i.item.stop == stop; });
    if (last == items.rend() || last->item.what != Happening::impact) return {};
    last->item.what = Happening::hold;
  }
  return items;
}

// The item at which the orbit begins: a release, which no chatter surrounds, or the fastest impact.
size_t first_item(const std::vector<ItemOfRun> &items) {
  size_t first = 0;
  double fastest = -1.0;
  for (size_t k = 0; k < items.size(); ++k) {
    const auto &[item, knot] = items[k];
    const double speed = releases(item.what) ? infinity : std::abs(knot->event->velocity_before);
    if (item.what == Happening::hold || !(speed > fastest)) continue;
    fastest = speed;
    first = k;
  }
  return first;
}

// The stop at which each mass without events is held, or -1.
std::vector<int> always_held(const Problem &problem, const Held &held,
                             const std::vector<ItemOfRun> &items) {
  std::vector<int> stops(held.size(), -1);
  for (size_t k = 0; k < problem.scene.stops.size(); ++k) {
    const Stop &stop = problem.scene.stops[k];
    const auto mass = static_cast<size_t>(stop.mass - 1);
    const bool has_events = std::ranges::any_of(
        items, [&](const ItemOfRun &i) { return problem.mass_of(i.item) == mass; });
    if (!has_events && held[mass] == static_cast<signed char>(stop.side))
      stops[mass] = static_cast<int>(k);
  }
  return stops;
}

}  // namespace

std::optional<SequenceOrbit> sequence_from_run(const Problem &problem, const MotionState &orbit,
                                               int periods) {
  const Clock clock(problem.scene.omega);
  // The run resolves the impacts that the sequence has.
  const double slowest = 0.05 * last_flight * problem.length * rate_bound(problem.scene);
  const Motion motion = motion_of(problem.scene, orbit, periods, {.limit_below_speed = slowest});
  const auto found = items_of(motion);
  if (!found) return {};
  std::vector<ItemOfRun> items = *found;
  Sequence s{
      .periods = periods, .items = {}, .always_held = always_held(problem, orbit.held, items)};
  MotionState start = orbit;
  std::vector<double> times = {0.0};  // of the items, from the start of the run
  size_t wraps = 0;                   // the flight in which the run ends
  if (items.empty()) {
    s.items = {{Happening::start, 0}};
    Simulation to_phase_zero(problem.scene, motion.start());
    start = require_complete(to_phase_zero.advance(clock.period)).state;
    start.instant = {};
  } else {
    const size_t first = first_item(items);
    start = items[first].knot->state;
    wraps = items.size() - 1 - first;
    times.clear();
    std::rotate(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(first), items.end());
    for (const auto &[item, knot] : items) {
      s.items.push_back(item);
      times.push_back(elapsed(motion.start().instant, knot->state.instant, clock));
    }
  }
  Vector u = Vector::Zero(problem.unknowns(s));
  u(0) = get(problem.scene, problem.parameter);
  u(1) = problem.scene.omega * start.instant.phase;
  const Model model(problem.scene, problem.parameter, u(0));
  const State touched = start_of(problem, model, s, u, 1);
  for (size_t i = 0; i < problem.masses(); ++i) {
    const int stop = touched.touched[i];
    u(problem.y_at(i)) = start.displacement[i] - (stop < 0 ? 0.0 : model.stop(stop).position.value);
    u(problem.v_at(i)) = start.velocity[i];
  }
  for (size_t k = 0; k < s.items.size(); ++k)
    u(problem.time_at(k)) =
        times[(k + 1) % times.size()] - times[k] + (k == wraps ? periods * clock.period : 0.0);
  return SequenceOrbit{s, u};
}

}  // namespace vibro_impact::branches
