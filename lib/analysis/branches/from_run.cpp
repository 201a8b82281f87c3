#include <algorithm>
#include <cmath>

#include "sequence.hpp"
#include "simulation/for_analysis.hpp"
#include "tolerances.hpp"
#include "vibro_impact/analysis/parameter.hpp"
#include "vibro_impact/simulate.hpp"

namespace vibro_impact::branches {

namespace {

// The events of a run with the states after them.
struct StateRecorder : Recorder {
  Held held;
  std::vector<Event> events = {};
  std::vector<MotionState> states = {};

  explicit StateRecorder(Held at_start) : held(std::move(at_start)) {
  }
  void event(const Event &event, const Moment &moment) override {
    held = event.held;
    events.push_back(event);
    states.push_back(state_at(moment, held));
  }
};

// An item of the sequence, and the event of the run that it is.
struct ItemOfRun {
  Item item;
  size_t event;
};

// The items of a run: the impact before a stick holds the mass. Nothing if a stick has none.
std::optional<std::vector<ItemOfRun>> items_of(const std::vector<Event> &events) {
  std::vector<ItemOfRun> items;
  for (size_t e = 0; e < events.size(); ++e) {
    const Event &event = events[e];
    const int stop = event.stop - 1;
    if (event.kind == EventKind::impact) items.push_back({{Happening::impact, stop}, e});
    if (event.kind == EventKind::release)
      items.push_back({{event.by_a_jump ? Happening::jump : Happening::release, stop}, e});
    if (event.kind != EventKind::stick) continue;
    const auto last = std::find_if(items.rbegin(), items.rend(),
                                   [stop](const ItemOfRun &i) { return i.item.stop == stop; });
    if (last == items.rend() || last->item.what != Happening::impact) return {};
    last->item.what = Happening::hold;
  }
  return items;
}

// The item at which the orbit begins: a release, which no chatter surrounds, or the fastest impact.
size_t first_item(const std::vector<ItemOfRun> &items, const std::vector<Event> &events) {
  size_t first = 0;
  double fastest = -1.0;
  for (size_t k = 0; k < items.size(); ++k) {
    const auto &[item, event] = items[k];
    const double speed = releases(item.what) ? infinity : std::abs(events[event].velocity_before);
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
  const double begin = time_of(orbit.instant, clock);
  StateRecorder run(orbit.held);
  // The run resolves the impacts that the sequence has.
  const double slowest = 0.05 * last_flight * problem.length * rate_bound(problem.scene);
  Simulation simulation(problem.scene, orbit, {.limit_below_speed = slowest});
  if (simulation.advance(begin + periods * clock.period, run).ending != Ending::reached) return {};
  const auto found = items_of(run.events);
  if (!found) return {};
  std::vector<ItemOfRun> items = *found;
  Sequence s{
      .periods = periods, .items = {}, .always_held = always_held(problem, orbit.held, items)};
  MotionState start = orbit;
  std::vector<double> times = {0.0};  // of the items, from the start of the run
  size_t wraps = 0;                   // the flight in which the run ends
  if (items.empty()) {
    s.items = {{Happening::start, 0}};
    Simulation to_phase_zero(problem.scene, orbit);
    start =
        require_complete(to_phase_zero.advance(begin + clock.period - orbit.instant.phase)).state;
    start.instant = {};
  } else {
    const size_t first = first_item(items, run.events);
    start = run.states[items[first].event];
    wraps = items.size() - 1 - first;
    times.clear();
    std::rotate(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(first), items.end());
    for (const auto &[item, event] : items) {
      s.items.push_back(item);
      times.push_back(elapsed(orbit.instant, run.events[event].instant, clock));
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
