// Published results: numbers that others printed, each as the library computes it. A row of
// reference/published.csv names its quantity, which is one of the functions here, and the
// parameters that this function is given. reference/README.md has the sources.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "reference/scenes/extreme_scenes.hpp"
#include "reference/scenes/published_scenes.hpp"
#include "reference/table_reader.hpp"
#include "vibro_impact/analysis/analysis.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace vibro_impact::published {

using extremes::one_mass;
using Parameters = std::map<std::string, double>;  // at() throws for one that is not there

// --- One mass before one stop: x'' + c x' + x = A cos(omega t), x <= stop ---------------------

// The periodic orbits of one impact in n forcing periods.
struct OneImpactOrbit {
  Scene scene;
  PeriodicOrbit orbit;
  Event impact;

  double speed() const {
    return std::abs(impact.velocity_before);
  }
  // The multiplier nearest to -1. At a period doubling it is -1.
  double doubling_multiplier() const {
    double nearest = orbit.multipliers.front().real();
    for (const auto &multiplier : orbit.multipliers)
      if (std::abs(multiplier + 1.0) < std::abs(nearest + 1.0)) nearest = multiplier.real();
    return nearest;
  }
  // The state at forcing phase pi.
  MotionState at_pi() const {
    const double pi = std::acos(-1.0), phase = orbit.state.instant.phase * scene.omega;
    return simulate(scene, orbit.state, (phase < pi ? pi : 3.0 * pi) / scene.omega).state;
  }
};

// Finds the orbit by Newton's method on the stroboscopic map, from an impact near `time` with about
// `speed`. Throws std::runtime_error if there is no such orbit.
inline OneImpactOrbit one_impact_orbit(const Parameters &p) {
  const int periods = static_cast<int>(p.at("n"));
  const Scene scene =
      one_mass(p.at("c"), p.at("A"), p.at("omega"), p.at("r"), p.at("stop"), p.at("stop"));
  const double period = Clock(scene.omega).period;
  MotionState guess = start_of(scene);
  guess.instant = {0, std::fmod(p.at("time"), period)};
  guess.velocity = {-scene.restitution * p.at("speed")};
  guess = at_quiet_phase(scene, guess);
  const PeriodicOrbit orbit = find_periodic_orbit(scene, guess, periods);
  if (!orbit.converged) throw std::runtime_error("no orbit of one impact: " + orbit.why_not);
  EventRecorder recorder;
  stroboscopic_map(scene, orbit.state, periods, {}, recorder);
  if (recorder.events.size() != 1)
    throw std::runtime_error("the orbit has " + std::to_string(recorder.events.size()) +
                             " events, not one impact");
  return {scene, orbit, recorder.events.front()};
}

// The parameters, of which the named one is moved to where f of the orbit is zero. Secants start at
// the given value and `step` away from it, and end at rounding.
inline Parameters solved_for(const std::string &name, double step, Parameters p,
                             const std::function<double(const OneImpactOrbit &)> &f) {
  double &x = p.at(name), last = x, value = f(one_impact_orbit(p));
  x += step;
  for (int iteration = 0; iteration < 20; ++iteration) {
    const double next_value = f(one_impact_orbit(p)), slope = (next_value - value) / (x - last);
    last = std::exchange(x, x - next_value / slope);
    value = next_value;
    if (!(std::abs(x - last) > 1e-14 * std::abs(x))) return p;
  }
  return p;
}

// The amplitude of the orbit with the impact speed `speed`.
inline double amplitude_of_speed(const Parameters &p) {
  const double speed = p.at("speed");
  return solved_for("A", 1e-7, p, [=](const auto &orbit) { return orbit.speed() - speed; }).at("A");
}

// The parameters at which a multiplier is -1, the amplitude or the stop being moved.
inline Parameters period_doubling(const std::string &moved, double step, const Parameters &p) {
  return solved_for(moved, step, p,
                    [](const auto &orbit) { return orbit.doubling_multiplier() + 1.0; });
}

// Number of impacts in one forcing period of the motion that is periodic without the stop. It
// starts at a phase at which the mass is on the side away from the stop.
inline int impacts_of_steady_motion(const Scene &scene) {
  Scene without = scene;
  without.stops.clear();
  MotionState state = find_periodic_orbit(without, start_of(without), 1).state;
  if (state.displacement.front() > 0.0)
    state = simulate(without, state, 0.5 * Clock(scene.omega).period).state;
  ImpactSpeedRecorder impacts{1, 0.0};
  stroboscopic_map(scene, state, 1, {}, impacts);
  return static_cast<int>(impacts.velocities.size());
}

// The amplitude A at which the motion without impact grazes the stop.
inline double grazing_amplitude(const Parameters &p) {
  const CountJump change = bisect(
      [&](double amplitude) {
        return impacts_of_steady_motion(one_mass(p.at("c"), amplitude, p.at("omega"), 0.8, 1.0)) >
               0;
      },
      0.01, 4.0);
  return 0.5 * (change.below + change.above);
}

// --- Runs ------------------------------------------------------------------------------------

// The event of that number (from 1) and kind. Chatter is carried to its limit, or every impact is
// resolved.
inline Event event_of(const Scene &scene, double until, EventKind kind, double count = 1.0,
                      bool every_impact = false) {
  EventRecorder recorder;
  RunOptions options;
  if (every_impact) options.resolve_chatter = 0.0;
  require_complete(simulate(scene, until, options, recorder));
  for (const Event &event : recorder.events)
    if (event.kind == kind && --count == 0.0) return event;
  throw std::runtime_error("the run has no such event");
}

// A ball above the floor, and below a ceiling if the parameters have one.
inline Scene ball_of(const Parameters &p) {
  Scene scene =
      ball(p.at("mass"), p.at("k"), p.at("force"), p.at("r"), p.at("height"), p.at("velocity"));
  if (p.contains("ceiling")) scene.stops.push_back({1, Side::upper, p.at("ceiling")});
  return scene;
}

inline Event impact_of_ball(const Parameters &p) {
  return event_of(ball_of(p), 10.0, EventKind::impact, p.at("impact"), true);
}

// --- The bar -----------------------------------------------------------------------------------

constexpr double end_of_bar = 0.0015;  // the bar has left the wall by this time

// From the first contact of the bar of that many elements with the wall to the release.
inline double contact_time(int elements) {
  const Scene scene = bar(elements, elements);
  return event_of(scene, end_of_bar, EventKind::release).time -
         event_of(scene, end_of_bar, EventKind::stick).time;
}

inline Scene bar_of(const Parameters &p) {
  return bar(static_cast<int>(p.at("elements")), static_cast<int>(p.at("per_length")));
}

// The momentum that the wall gives to the bar.
inline double impulse_of_the_wall(const Scene &scene) {
  const MotionState end = require_complete(simulate(scene, end_of_bar)).state;
  double impulse = 0.0;
  for (std::size_t i = 0; i < scene.mass.size(); ++i)
    impulse += scene.mass[i] * (end.velocity[i] - scene.velocity[i]);
  return impulse;
}

// --- The table -----------------------------------------------------------------------------------

// The library's value of every quantity that the table names.
inline const std::map<std::string, double (*)(const Parameters &)> &quantities() {
  using P = const Parameters &;
  static const std::map<std::string, double (*)(P)> functions{
      {"impact_speed", [](P p) { return one_impact_orbit(p).speed(); }},
      {"impact_phase", [](P p) { return one_impact_orbit(p).impact.instant.phase; }},
      {"velocity_after", [](P p) { return one_impact_orbit(p).impact.velocity_after; }},
      {"displacement_at_pi", [](P p) { return one_impact_orbit(p).at_pi().displacement.front(); }},
      {"velocity_at_pi", [](P p) { return one_impact_orbit(p).at_pi().velocity.front(); }},
      {"doubling_speed",
       [](P p) { return one_impact_orbit(period_doubling("stop", 1e-6, p)).speed(); }},
      {"amplitude_of_speed", amplitude_of_speed},
      {"amplitude_of_doubling", [](P p) { return period_doubling("A", 1e-7, p).at("A"); }},
      {"grazing_amplitude", grazing_amplitude},
      {"first_order_chatter_limit",
       [](P p) {
         const Scene scene = one_mass(0.0, 1.0, p.at("omega"), p.at("r"), p.at("stop"),
                                      p.at("stop"), -p.at("speed"));
         return event_of(scene, 1.0, EventKind::stick).time;
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
         return p.at("start") + event_of(bar_of(p), end_of_bar, EventKind::release).time;
       }},
      {"bar_impulse", [](P p) { return impulse_of_the_wall(bar_of(p)); }},
  };
  return functions;
}

struct Result {
  std::string id, source, quantity;
  std::string given;    // the parameters, as the table has them
  std::string printed;  // as it stands in the source
  std::string kind;     // printed, formula, summed or derived (reference/README.md)
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
    values[word.substr(0, equals)] = figures::number_in(table, word.substr(equals + 1));
  }
  return values;
}

// Columns: id,source,quantity,parameters,printed,tolerance,kind,limited_by.
inline std::vector<Result> results(const std::string &folder) {
  const std::string name = folder + "/published.csv";
  std::vector<Result> rows;
  for (const auto &cells : figures::read_rows(name, 8))
    rows.push_back({cells[0], cells[1], cells[2], cells[3], cells[4], cells[6],
                    figures::number_in(name, cells[4]), figures::number_in(name, cells[5]),
                    cells[7], read_parameters(name, cells[3])});
  return rows;
}

}  // namespace vibro_impact::published
