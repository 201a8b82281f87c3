// One extreme case run and judged: its errors, how sensitive it is, its work.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "figures/event_tables.hpp"
#include "reference/event_comparison.hpp"
#include "reference/scenes/extreme_cases.hpp"
#include "vibro_impact/analysis/natural_modes.hpp"
#include "vibro_impact/simulate.hpp"

namespace vibro_impact::extremes {

using figures::Differences;
using figures::EventTables;

// Samples between the events: the deepest penetration of a stop, the size of the motion.
struct Samples {
  const Scene *scene;
  double from, until, every;
  std::size_t taken = 0;
  double penetration = 0.0, size = 0.0, speed = 0.0;
  bool finite = true;

  double next_time() const {
    return sample_time(from, until, every, taken);
  }
  void sample(const Moment &moment) {
    ++taken;
    for (int mass = 1; mass <= scene->masses(); ++mass) {
      const double x = moment.displacement(mass), v = moment.velocity(mass);
      finite = finite && std::isfinite(x) && std::isfinite(v);
      size = std::max(size, std::abs(x));
      speed = std::max(speed, std::abs(v));
    }
    for (const Stop &stop : scene->stops)
      penetration =
          std::max(penetration, sign(stop.side) * (moment.displacement(stop.mass) - stop.position));
  }
};

// What a case came to. Times relative to `period`, velocities to the largest, displacements to the
// largest.
struct Measured {
  double period = 0.0;
  Differences differences;
  double conditioning = 0.0;  // largest change of an event time per relative change of the start
  double penetration = 0.0;
  bool finite = true;
  Counters counters;
  bool pass = false;
};

// The forcing period; without forcing, the longest natural period of the chain.
inline double period_of(const Scene &scene) {
  if (scene.forced() && scene.omega > 0.0) return 2.0 * std::numbers::pi / scene.omega;
  double slowest = std::numeric_limits<double>::infinity();
  for (const double lambda : natural_modes(scene, Held(scene.mass.size(), 0)).lambda)
    if (lambda > 0.0) slowest = std::min(slowest, lambda);
  return 2.0 * std::numbers::pi / std::sqrt(slowest);
}

namespace detail {

// Events of a run that are compared.
inline std::vector<TrueEvent> events_of(const Scene &scene, const Case &extreme,
                                        Outcome *outcome = nullptr) {
  EventRecorder recorder{extreme.from};
  const Outcome result = require_complete(simulate(scene, extreme.until, {}, recorder));
  if (outcome != nullptr) *outcome = result;
  return figures::as_truth(recorder.events);
}

// The changes made to a start to see what becomes of them, relative to the motion. The smaller one
// is tried where the larger one makes other events, as with a contact that it undoes. It is large
// enough for noise not to excuse itself: an error e that comes from nothing raises the sensitivity
// by e / 1e-13, and with it what 100 roundings excuse by a fifth of e only.
constexpr double perturbations[] = {1e-10, 1e-13};

// What is changed: displacements or velocities, of neighbours alike or in turn (which strains every
// link), or the forcing.
struct Change {
  enum class Of { displacement, velocity, amplitude } of;
  bool in_turn;
};

// Masses on their stops stay there: leaving would be another scene.
inline Scene perturbed(const Scene &scene, const Change &change, double relative, double size,
                       double speed) {
  Scene result = scene;
  if (change.of == Change::Of::amplitude) {
    for (double &a : result.amplitude) a *= 1.0 + relative;
    return result;
  }
  result.displacement.resize(scene.mass.size(), 0.0);
  result.velocity.resize(scene.mass.size(), 0.0);
  for (std::size_t i = 0; i < scene.mass.size(); ++i) {
    bool near = false;
    for (const Stop &stop : scene.stops)
      near = near || (stop.mass == static_cast<int>(i) + 1 &&
                      std::abs(stop.position - result.displacement[i]) <= 2 * relative * size);
    if (near) continue;
    const double sense = change.in_turn && i % 2 == 1 ? -1.0 : 1.0;
    if (change.of == Change::Of::displacement)
      result.displacement[i] += sense * relative * size;
    else
      result.velocity[i] += sense * relative * speed;
  }
  return result;
}

// Every change tried.
inline std::vector<Change> changes(const Scene &scene) {
  std::vector<Change> all;
  for (const auto of : {Change::Of::displacement, Change::Of::velocity})
    for (const bool in_turn : {false, true})
      if (!in_turn || scene.masses() > 1) all.push_back({of, in_turn});
  if (scene.forced()) all.push_back({Change::Of::amplitude, false});
  return all;
}

}  // namespace detail

// Runs a case: once as it is, once sampled, and perturbed. `tables` holds the truth of the
// generator's cases.
inline Measured measure(const Case &extreme, const EventTables &tables) {
  const Scene &scene = extreme.scene;
  Measured result;
  result.period = period_of(scene);
  Outcome outcome;
  const std::vector<TrueEvent> events = detail::events_of(scene, extreme, &outcome);
  result.counters = outcome.counters;
  const auto truth = extreme.truth == Truth::digits ? tables.at(extreme.name) : extreme.events;
  result.differences = extreme.truth == Truth::grazing
                           ? compare_grazing(events, truth, scene)
                           : compare(events, truth, scene, {.period = result.period});

  // A long run is sampled and perturbed over its first 1000 periods only.
  Case shorter = extreme;
  if (extreme.from > 0.0) {
    shorter.from = 0.0;
    shorter.until = std::min(extreme.until, 1000.0 * result.period);
  }
  Samples samples{&scene, 0.0, shorter.until, shorter.until / 1000};
  require_complete(simulate(scene, shorter.until, {}, samples));
  const auto finite = [](const std::vector<double> &values) {
    return std::all_of(values.begin(), values.end(),
                       [](double value) { return std::isfinite(value); });
  };
  result.finite =
      samples.finite && finite(outcome.state.displacement) && finite(outcome.state.velocity);
  double speed = samples.speed;
  for (const TrueEvent &event : truth) speed = std::max(speed, std::abs(event.velocity_before));
  const auto relative = [](double value, double scale) {
    return scale > 0.0 ? value / scale : value;
  };
  result.penetration = relative(samples.penetration, samples.size);

  const auto unchanged = extreme.from > 0.0 ? detail::events_of(scene, shorter) : events;
  for (const detail::Change &change : detail::changes(scene)) {
    for (const double by : detail::perturbations) {
      const Scene changed = detail::perturbed(scene, change, by, samples.size, speed);
      const Differences difference = compare(detail::events_of(changed, shorter), unchanged, scene,
                                             {.period = result.period, .runs = true});
      result.conditioning = std::max(result.conditioning, difference.time / result.period / by);
      if (difference.first.empty()) break;
    }
  }
  result.differences.time /= result.period;
  result.differences.velocity = relative(result.differences.velocity, speed);

  // A touch is compared within what a stop 100 roundings away would do, so it passes by agreeing.
  const double rounding = 100.0 * std::numeric_limits<double>::epsilon();
  result.pass = result.differences.first.empty() && result.finite && result.penetration <= 1e-12 &&
                (extreme.truth == Truth::grazing || result.differences.time <= 1e-10 ||
                 result.differences.time <= rounding * result.conditioning);
  return result;
}

}  // namespace vibro_impact::extremes
