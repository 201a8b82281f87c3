#include "extreme_verdict.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "reference/truth/event_comparison.hpp"
#include "runs.hpp"
#include "vibro_impact/analysis/natural_modes.hpp"

namespace vibro_impact::stability {

namespace {

// The perturbations of a start, relative to the motion. The smaller one is tried where the larger
// one makes other events, as it does where it undoes a contact. An error e that comes from nothing
// raises the sensitivity by e / 1e-13, so that 100 roundings of it excuse a fifth of e only.
constexpr double perturbations[] = {1e-10, 1e-13};

// The forcing period; without forcing, the longest natural period of the chain.
double period_of(const Scene &scene) {
  if (scene.forced() && scene.omega > 0.0) return 2.0 * std::numbers::pi / scene.omega;
  double slowest = infinity;
  for (const double lambda : natural_modes(scene, Held(scene.mass.size(), 0)).lambda)
    if (lambda > 0.0) slowest = std::min(slowest, lambda);
  return 2.0 * std::numbers::pi / std::sqrt(slowest);
}

// The start with neighbours moved by `step` in opposite directions, which strains every link.
// Masses on their stops stay there, because a start away from the stop is another scene.
Scene perturbed(Scene scene, double step) {
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

Relative relative(const truth::Differences &differences, double period, double speed) {
  return {differences.time / period,
          speed > 0.0 ? differences.velocity / speed : differences.velocity};
}

}  // namespace

void Samples::sample(const Moment &moment) {
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

bool passes(const ExtremeErrors &measured, Truth truth) {
  const auto right = [](double error, double sensitivity) {
    return error <= 1e-10 || error <= 100.0 * std::numeric_limits<double>::epsilon() * sensitivity;
  };
  return measured.difference.empty() && measured.finite && measured.penetration <= 1e-12 &&
         (truth == Truth::grazing ||
          (right(measured.error.time, measured.sensitivity.time) &&
           right(measured.error.velocity, measured.sensitivity.velocity)));
}

Relative sensitivity_of(const Scene &scene, double until, double period, const Samples &motion) {
  const std::vector<Event> unperturbed = figures::events_of(scene, 0.0, until);
  Relative largest;
  for (const double by : perturbations) {
    const truth::Differences differences =
        truth::compare(figures::events_of(perturbed(scene, by * motion.size), 0.0, until),
                       unperturbed, scene, {.reach = 1e-3 * period, .runs = true});
    const Relative found = relative(differences, period, motion.speed);
    largest.time = std::max(largest.time, found.time / by);
    largest.velocity = std::max(largest.velocity, found.velocity / by);
    if (differences.first.empty()) break;
  }
  return largest;
}

ExtremeErrors measure(const Case &extreme, const EventTables &tables) {
  const Scene &scene = extreme.scene;
  const double period = period_of(scene);
  EventRecorder recorder(extreme.from, infinity);
  const Outcome outcome = require_complete(simulate(scene, extreme.until, recorder));
  const auto truth = extreme.truth == Truth::digits ? tables.at(extreme.name) : extreme.events;
  const truth::Differences differences =
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
          relative(differences, period, motion.speed),
          sensitivity_of(scene, until, period, motion),
          motion.size > 0.0 ? motion.penetration / motion.size : motion.penetration,
          motion.finite && finite(outcome.state.displacement) && finite(outcome.state.velocity),
          outcome.counters};
}

}  // namespace vibro_impact::stability
