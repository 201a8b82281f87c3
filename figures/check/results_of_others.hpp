// Published results: numbers that others printed, each as the library computes it. A row of
// reference/tables/published.csv names its quantity, which is one of the functions below, and the
// parameters that this function is given. reference/README.md has the sources.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <complex>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "reference/scenes/extreme_scenes.hpp"
#include "reference/truth/table_reader.hpp"
#include "vibro_impact/analysis/analysis.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace vibro_impact::published {

using extremes::one_mass;
using Parameters = std::map<std::string, double>;  // at() throws for a missing one

// --- One mass before one stop: x'' + c x' + x = A cos(omega t), x <= stop ---------------------

// The multiplier nearest to `target`: -1 at a period doubling, 1 at a fold.
inline double multiplier_near(double target, const std::vector<std::complex<double>> &multipliers) {
  double nearest = multipliers.front().real();
  for (const auto &multiplier : multipliers)
    if (std::abs(multiplier - target) < std::abs(nearest - target)) nearest = multiplier.real();
  return nearest;
}

// A ball of weight g on a table that vibrates with the acceleration -A cos(omega t), in coordinates
// of the table.
inline Scene ball_on_table(const Parameters &p) {
  Scene scene{.mass = {1.0},
              .stiffness = {0.0},
              .amplitude = {p.at("A")},
              .omega = p.at("omega"),
              .restitution = p.at("r"),
              .stops = {{1, Side::lower, 0.0}}};
  scene.constant = {-p.at("g")};
  return scene;
}

// The motion from an impact at `time` with `speed`, far from that impact: of a ball on a table
// where a weight g is given, of a mass on a spring elsewhere.
inline std::pair<Scene, MotionState> after_impact(const Parameters &p) {
  const Scene scene = p.contains("g") ? ball_on_table(p)
                                      : one_mass(p.at("c"), p.at("A"), p.at("omega"), p.at("r"),
                                                 p.at("stop"), p.at("stop"));
  MotionState after = start_of(scene);
  after.instant = {0, std::fmod(p.at("time"), Clock(scene.omega).period)};
  after.velocity = {-sign(scene.stops[0].side) * scene.restitution * p.at("speed")};
  return {scene, at_quiet_phase(scene, after)};
}

// A periodic orbit of one impact in n forcing periods.
struct OneImpactOrbit {
  Scene scene;
  PeriodicOrbit orbit;
  Event impact;
};

// Finds the orbit by Newton's method on the stroboscopic map, from an impact near `time` with about
// `speed`. Throws std::runtime_error if there is no such orbit.
inline OneImpactOrbit one_impact_orbit(const Parameters &p) {
  const int periods = static_cast<int>(p.at("n"));
  const auto [scene, guess] = after_impact(p);
  const PeriodicOrbit orbit = find_periodic_orbit(scene, guess, periods);
  if (!orbit.converged) throw std::runtime_error("no orbit of one impact: " + orbit.why_not);
  EventRecorder recorder;
  stroboscopic_map(scene, orbit.state, periods, {}, recorder);
  if (recorder.events.size() != 1)
    throw std::runtime_error("the orbit has " + std::to_string(recorder.events.size()) +
                             " events, not one impact");
  return {scene, orbit, recorder.events.front()};
}

// --- Runs ------------------------------------------------------------------------------------

// The event of that number (from 1) and kind. Chatter is carried to its limit, or every impact is
// resolved.
inline Event event_of(const Scene &scene, double until, EventKind kind, double count = 1.0,
                      bool every_impact = false) {
  EventRecorder recorder;
  RunOptions options;
  if (every_impact) options.limit_below_speed = 0.0;
  require_complete(simulate(scene, until, options, recorder));
  for (const Event &event : recorder.events)
    if (event.kind == kind && --count == 0.0) return event;
  throw std::runtime_error("the run has no such event");
}

// A mass thrown at a lower stop at 0, under a constant force (omega = 0: the cosine is one) and,
// with k > 0, on a spring; below a ceiling if the parameters have one.
inline Scene ball_of(const Parameters &p) {
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

inline Event impact_of_ball(const Parameters &p) {
  return event_of(ball_of(p), 10.0, EventKind::impact, p.at("impact"), true);
}

// --- The bar -----------------------------------------------------------------------------------

// A bar of elements thrown at a wall, r = 0. E = 210e9, rho = 7800, section 3.14e-4, length 1, as
// in the example of Siconos. Masses lumped at the nodes, half of one at each end; `elements` of
// them have the length of 1 / `per_length`.
constexpr double elasticity = 210e9, density = 7800.0, section = 0.000314;

inline Scene bar(int elements, int per_length) {
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

constexpr double end_of_bar = 0.0015;  // the bar has left the wall by this time

// From the first contact of the bar of that many elements with the wall to the release.
inline double contact_time(int elements) {
  const Scene scene = bar(elements, elements);
  return event_of(scene, end_of_bar, EventKind::release).time -
         event_of(scene, end_of_bar, EventKind::stick).time;
}

// --- The table -----------------------------------------------------------------------------------

// The library's value of every quantity that the table names.
inline const std::map<std::string, double (*)(const Parameters &)> &quantities() {
  using P = const Parameters &;
  static const std::map<std::string, double (*)(P)> functions{
      {"impact_speed", [](P p) { return std::abs(one_impact_orbit(p).impact.velocity_before); }},
      {"impact_phase", [](P p) { return one_impact_orbit(p).impact.instant.phase; }},
      {"velocity_after", [](P p) { return one_impact_orbit(p).impact.velocity_after; }},
      {"doubling_multiplier",
       [](P p) { return multiplier_near(-1.0, one_impact_orbit(p).orbit.multipliers); }},
      {"fold_multiplier",  // the orbit is given: two orbits meet, so Newton's method fails
       [](P p) {
         const auto [scene, start] = after_impact(p);
         const auto map =
             stroboscopic_map_and_derivative(scene, start, static_cast<int>(p.at("n")));
         return multiplier_near(1.0, floquet_multipliers(map.derivative, start.held));
       }},
      {"release_time",
       [](P p) {
         const Scene scene = one_mass(0.0, 1.0, p.at("omega"), 0.5, p.at("stop"), p.at("stop"));
         return event_of(scene, Clock(p.at("omega")).period, EventKind::release).time;
       }},
      {"chatter_limit", [](P p) { return event_of(ball_of(p), 10.0, EventKind::stick).time; }},
      {"impact_time", [](P p) { return impact_of_ball(p).time; }},
      {"bar_contact_time", [](P p) { return contact_time(static_cast<int>(p.at("elements"))); }},
      {"bar_end_of_contact",
       [](P p) {
         const Scene scene =
             bar(static_cast<int>(p.at("elements")), static_cast<int>(p.at("per_length")));
         return p.at("start") + event_of(scene, end_of_bar, EventKind::release).time;
       }},
  };
  return functions;
}

struct Result {
  std::string id, source, quantity;
  std::string given;    // the parameters, as the table has them
  std::string printed;  // as it stands in the source
  std::string kind;     // printed, formula or derived (reference/README.md)
  double value = 0.0;   // of what is printed
  double tolerance = 0.0;
  std::string limited_by;  // whose error limits the agreement (theirs, ours or both), and why
  Parameters parameters = {};

  // The library's value. Throws std::runtime_error naming a row of which it cannot be computed.
  double compute() const {
    try {
      return quantities().at(quantity)(parameters);
    } catch (const std::exception &error) {
      throw std::runtime_error(fmt::format("{}, {} {}: {}", id, quantity, given, error.what()));
    }
  }
};

// "name=value name=value"
inline Parameters read_parameters(const std::string &table, const std::string &cell) {
  Parameters values;
  std::istringstream words(cell);
  for (std::string word; words >> word;) {
    const auto equals = word.find('=');
    if (equals == std::string::npos)
      throw std::runtime_error(fmt::format("{}: '{}' is not name=value", table, word));
    values[word.substr(0, equals)] = truth::number_in(table, word.substr(equals + 1));
  }
  return values;
}

// Columns: id,source,quantity,parameters,printed,tolerance,kind,limited_by.
inline std::vector<Result> results(const std::string &folder) {
  const std::string name = folder + "/published.csv";
  std::vector<Result> rows;
  for (const auto &cells : truth::read_rows(name, 8))
    rows.push_back({cells[0], cells[1], cells[2], cells[3], cells[4], cells[6],
                    truth::number_in(name, cells[4]), truth::number_in(name, cells[5]), cells[7],
                    read_parameters(name, cells[3])});
  return rows;
}

}  // namespace vibro_impact::published
