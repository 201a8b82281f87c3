#include "published_results.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "figures/measures/runs.hpp"
#include "reference/scenes/extreme_scenes.hpp"

namespace vibro_impact::published {

using extremes::one_mass;

// --- One mass before one stop: x'' + c x' + x = A cos(omega t), x <= stop ---------------------

double multiplier_near(double target, const std::vector<std::complex<double>> &multipliers) {
  const auto distance = [target](const auto &multiplier) { return std::abs(multiplier - target); };
  return std::ranges::min(multipliers, {}, distance).real();
}

namespace {

// A ball of weight g on a table that vibrates with the acceleration -A cos(omega t), in coordinates
// of the table.
Scene ball_on_table(const Arguments &p) {
  Scene scene{.mass = {1.0},
              .stiffness = {0.0},
              .amplitude = {p.at("A")},
              .omega = p.at("omega"),
              .restitution = p.at("r"),
              .stops = {{1, Side::lower, 0.0}}};
  scene.constant = {-p.at("g")};
  return scene;
}

}  // namespace

std::pair<Scene, MotionState> after_impact(const Arguments &p) {
  Scene scene = p.contains("g") ? ball_on_table(p)
                                : one_mass(p.at("c"), p.at("A"), p.at("omega"), p.at("r"),
                                           p.at("stop"), p.at("stop"));
  if (p.contains("wall")) scene.stops.push_back({1, Side::lower, p.at("wall")});
  MotionState after = start_of(scene);
  after.instant = {0, std::fmod(p.at("time"), Clock(scene.omega).period)};
  after.velocity = {-sign(scene.stops[0].side) * scene.restitution * p.at("speed")};
  return {scene, at_quiet_phase(scene, after)};
}

OneImpactOrbit one_impact_orbit(const Arguments &p) {
  const int periods = static_cast<int>(p.at("n"));
  const auto [scene, guess] = after_impact(p);
  const PeriodicOrbit orbit = find_periodic_orbit(scene, guess, periods);
  if (!orbit.converged) throw std::runtime_error("no orbit of one impact: " + orbit.why_not);
  EventRecorder recorder(0.0, infinity);
  stroboscopic_map(scene, orbit.state, periods, {}, recorder);
  if (recorder.events.size() != scene.stops.size())
    throw std::runtime_error("the orbit has " + std::to_string(recorder.events.size()) +
                             " events, not one impact at each stop");
  return {scene, orbit, recorder.events.front()};
}

namespace {

// --- Runs ------------------------------------------------------------------------------------

// The event of that number (from 1) and kind. Chatter is carried to its limit, or every impact is
// resolved.
Event event_of(const Scene &scene, double until, EventKind kind, double count = 1.0,
               bool every_impact = false) {
  RunOptions options;
  if (every_impact) options.limit_below_speed = 0.0;
  for (const Event &event : figures::events_of(scene, 0.0, until, options))
    if (event.kind == kind && --count == 0.0) return event;
  throw std::runtime_error("the run has no such event");
}

// A mass thrown at a lower stop at 0, under a constant force (omega = 0: the cosine is one) and,
// with k > 0, on a spring; below a ceiling if the parameters have one.
Scene ball_of(const Arguments &p) {
  Scene scene{.mass = {p.at("mass")},
              .stiffness = {p.at("k")},
              .amplitude = {p.at("force")},
              .omega = 0.0,
              .restitution = p.at("r"),
              .stops = {{1, Side::lower, 0.0}},
              .displacement = {p.at("height")},
              .velocity = {p.at("velocity")}};
  if (p.contains("ceiling")) scene.stops.push_back({1, Side::upper, p.at("ceiling")});
  return scene;
}

// --- The bar -----------------------------------------------------------------------------------

// A bar of elements thrown at a wall, r = 0. E = 210e9, rho = 7800, section 3.14e-4, length 1, as
// in the example of Siconos. Masses lumped at the nodes, half of one at each end; `elements` of
// them have the length of 1 / `per_length`.
constexpr double elasticity = 210e9, density = 7800.0, section = 0.000314;

Scene bar(int elements, int per_length) {
  const double length = 1.0 / per_length;
  const auto nodes = static_cast<std::size_t>(elements) + 1;
  Scene scene;
  scene.mass.assign(nodes, density * section * length);
  scene.mass.front() *= 0.5;
  scene.mass.back() *= 0.5;
  scene.stiffness.assign(nodes, elasticity * section / length);
  scene.stiffness.front() = 0.0;
  scene.restitution = 0.0;
  scene.stops = {{1, Side::lower, 0.0}};
  scene.displacement.assign(nodes, 0.00005);
  scene.velocity.assign(nodes, -0.1);
  return scene;
}

}  // namespace

// --- The table -----------------------------------------------------------------------------------

void add_quantities(numbers::Quantities<figures::LibraryEngine> &all) {
  using figures::add;
  using P = const Arguments &;
  const std::string orbit = "c A omega r stop wall g n time speed",
                    ball = "mass k force r height velocity ceiling velocity_before";
  add(all, "impact_speed", orbit,
      [](P p) { return std::abs(one_impact_orbit(p).impact.velocity_before); });
  add(all, "impact_phase", orbit, [](P p) { return one_impact_orbit(p).impact.instant.phase; });
  add(all, "velocity_after", orbit, [](P p) { return one_impact_orbit(p).impact.velocity_after; });
  add(all, "doubling_multiplier", orbit,
      [](P p) { return multiplier_near(-1.0, *one_impact_orbit(p).orbit.multipliers); });
  // The orbit is given: at a fold two orbits meet, so that Newton's method fails.
  add(all, "fold_multiplier", orbit, [](P p) {
    const auto [scene, start] = after_impact(p);
    const auto map = stroboscopic_map_and_derivative(scene, start, static_cast<int>(p.at("n")));
    return multiplier_near(1.0, floquet_multipliers(scene, *map.derivative, start.held));
  });
  add(all, "release_time", "omega stop", [](P p) {
    const Scene scene = one_mass(0.0, 1.0, p.at("omega"), 0.5, p.at("stop"), p.at("stop"));
    return event_of(scene, Clock(p.at("omega")).period, EventKind::release).time;
  });
  add(all, "chatter_limit", ball,
      [](P p) { return event_of(ball_of(p), 10.0, EventKind::stick).time; });
  add(all, "impact_time", ball + " impact",
      [](P p) { return event_of(ball_of(p), 10.0, EventKind::impact, p.at("impact"), true).time; });
  add(all, "bar_end_of_contact", "elements per_length start", [](P p) {
    const Scene scene =
        bar(static_cast<int>(p.at("elements")), static_cast<int>(p.at("per_length")));
    return p.at("start") + event_of(scene, 0.0015, EventKind::release).time;
  });
}

}  // namespace vibro_impact::published
