// Runs one extreme case and judges it by its errors and its sensitivity to the start.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "figures/runs.hpp"
#include "reference/truth/event_comparison.hpp"
#include "reference/truth/event_reader.hpp"
#include "reference/truth/extreme_cases.hpp"
#include "vibro_impact/analysis/natural_modes.hpp"
#include "vibro_impact/simulate.hpp"

namespace vibro_impact::stability {

using truth::Case, truth::Truth, truth::Differences, truth::EventTables;

// Samples of the motion between its events: the largest displacement and speed, and the deepest
// penetration of a stop of `scene`.
struct Samples : Recorder {
  const Scene *scene;
  double until;
  std::size_t taken = 0;
  double penetration = 0.0, size = 0.0, speed = 0.0;
  bool finite = true;

  Samples(const Scene &of, double end) : scene(&of), until(end) {
  }
  double next_time() const override {
    return sample_time(0.0, until, until / 1000, taken);
  }
  void sample(const Moment &moment) override {
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

// Times relative to `period`, velocities relative to the largest speed, displacements relative to
// the largest one.
struct Relative {
  double time = 0.0, velocity = 0.0;
};

struct ExtremeErrors {
  std::string difference;  // the first event without a counterpart; empty when all agree
  std::size_t events = 0;  // compared
  Relative error;          // largest, of the events
  Relative sensitivity;    // largest change of an event per relative change of the start
  double penetration = 0.0;
  bool finite = true;
  Counters counters;
};

// A case passes when every event has its counterpart, all numbers are finite, no stop is penetrated
// by more than 1e-12 of the motion, and times and velocities are right to 1e-10, or to 100
// roundings times the sensitivity where the scene amplifies a change of its start. The events of a
// touch pass by having counterparts: compare_grazing allows them no more than a stop some roundings
// away does.
inline bool passes(const ExtremeErrors &measured, Truth truth) {
  const auto right = [](double error, double sensitivity) {
    return error <= 1e-10 || error <= 100.0 * std::numeric_limits<double>::epsilon() * sensitivity;
  };
  return measured.difference.empty() && measured.finite && measured.penetration <= 1e-12 &&
         (truth == Truth::grazing ||
          (right(measured.error.time, measured.sensitivity.time) &&
           right(measured.error.velocity, measured.sensitivity.velocity)));
}

// The forcing period; without forcing, the longest natural period of the chain.
inline double period_of(const Scene &scene) {
  if (scene.forced() && scene.omega > 0.0) return 2.0 * std::numbers::pi / scene.omega;
  double slowest = infinity;
  for (const double lambda : natural_modes(scene, Held(scene.mass.size(), 0)).lambda)
    if (lambda > 0.0) slowest = std::min(slowest, lambda);
  return 2.0 * std::numbers::pi / std::sqrt(slowest);
}

namespace detail {

// The perturbations of a start, relative to the motion. The smaller one is tried where the larger
// one makes other events, as it does where it undoes a contact. An error e that comes from nothing
// raises the sensitivity by e / 1e-13, so that 100 roundings of it excuse a fifth of e only.
constexpr double perturbations[] = {1e-10, 1e-13};

// The start with neighbours moved by `step` in opposite directions, which strains every link.
// Masses on their stops stay there, because a start away from the stop is another scene.
inline Scene perturbed(Scene scene, double step) {
  scene.displacement.resize(scene.mass.size(), 0.0);
  for (std::size_t i = 0; i < scene.mass.size(); ++i) {
    double &x = scene.displacement[i];
    const auto holds_it = [&](const Stop &stop) {
      return stop.mass == static_cast<int>(i) + 1 && std::abs(stop.position - x) <= 2.0 * step;
    };
    if (std::none_of(scene.stops.begin(), scene.stops.end(), holds_it))
      x += i % 2 == 0 ? step : -step;
  }
  return scene;
}

inline Relative relative(const Differences &differences, double period, double speed) {
  return {differences.time / period,
          speed > 0.0 ? differences.velocity / speed : differences.velocity};
}

inline Relative sensitivity_of(const Scene &scene, double until, double period,
                               const Samples &motion) {
  const std::vector<Event> unperturbed = figures::events_of(scene, 0.0, until);
  Relative largest;
  for (const double by : perturbations) {
    const Differences differences =
        truth::compare(figures::events_of(perturbed(scene, by * motion.size), 0.0, until),
                       unperturbed, scene, {.reach = 1e-3 * period, .runs = true});
    const Relative found = relative(differences, period, motion.speed);
    largest.time = std::max(largest.time, found.time / by);
    largest.velocity = std::max(largest.velocity, found.velocity / by);
    if (differences.first.empty()) break;
  }
  return largest;
}

}  // namespace detail

// Runs a case once as it is, once sampled, and perturbed. `tables` holds the events of the cases
// that are compared with the 50-digit generator.
inline ExtremeErrors measure(const Case &extreme, const EventTables &tables) {
  const Scene &scene = extreme.scene;
  const double period = period_of(scene);
  EventRecorder recorder(extreme.from);
  const Outcome outcome = require_complete(simulate(scene, extreme.until, recorder));
  const auto truth = extreme.truth == Truth::digits ? tables.at(extreme.name) : extreme.events;
  const Differences differences =
      extreme.truth == Truth::grazing
          ? truth::compare_grazing(recorder.events, truth, scene)
          : truth::compare(recorder.events, truth, scene, {.reach = 1e-3 * period});

  // A long run is sampled and perturbed over its first 1000 periods only.
  const double until =
      extreme.from > 0.0 ? std::min(extreme.until, 1000.0 * period) : extreme.until;
  Samples motion(scene, until);
  require_complete(simulate(scene, until, motion));
  for (const Event &event : truth)
    motion.speed = std::max(motion.speed, std::abs(event.velocity_before));
  const auto finite = [](const std::vector<double> &values) {
    return std::all_of(values.begin(), values.end(), [](double x) { return std::isfinite(x); });
  };
  return {differences.first,
          differences.matched,
          detail::relative(differences, period, motion.speed),
          detail::sensitivity_of(scene, until, period, motion),
          motion.size > 0.0 ? motion.penetration / motion.size : motion.penetration,
          motion.finite && finite(outcome.state.displacement) && finite(outcome.state.velocity),
          outcome.counters};
}

}  // namespace vibro_impact::stability
