// Published results: numbers that others printed, each with what the library makes of it. The
// numbers are tables in reference/ (published*.csv); reference/README.md has the sources.
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

#include "published_scenes.hpp"
#include "table_reader.hpp"

namespace vibro_impact::figures {

struct PublishedResult {
  std::string id, source;
  std::string quantity;  // with its parameters
  std::string printed;   // as it stands in the source
  double value = 0.0;    // of it
  double tolerance = 0.0;
  std::string limited_by;  // what limits the agreement: theirs, ours or both, and why
  std::function<double()> compute = {};
};

namespace published {

// "name=value name=value"
inline Parameters read_parameters(const std::string &table, const std::string &cell) {
  std::map<std::string, double> values;
  std::istringstream words(cell);
  for (std::string word; words >> word;) {
    const auto equals = word.find('=');
    if (equals == std::string::npos)
      throw std::runtime_error(fmt::format("{}: '{}' is not name=value", table, word));
    values[word.substr(0, equals)] = number_in(table, word.substr(equals + 1));
  }
  return Parameters(std::move(values));
}

inline Scene ball_of(const Parameters &p) {
  return ball(p["mass"], p["k"], p["force"], p["r"], p["height"], p["velocity"]);
}

// The library's value of every quantity that reference/published.csv names.
inline const std::map<std::string, double (*)(const Parameters &)> &quantities() {
  using P = const Parameters &;
  static const std::map<std::string, double (*)(P)> functions{
      {"budd_dux_speed", budd_dux_speed},
      {"budd_dux_doubling_speed", budd_dux_doubling_speed},
      {"budd_dux_chatter_limit",
       [](P p) {
         const Scene scene =
             one_mass(0.0, 1.0, p["omega"], p["r"], p["stop"], p["stop"], -p["speed"]);
         return first_time_of(events_to(scene, 1.0), EventKind::stick);
       }},
      {"release_time",
       [](P p) {
         const Scene scene = one_mass(0.0, 1.0, p["omega"], 0.5, p["stop"], p["stop"]);
         return first_time_of(events_to(scene, Clock(p["omega"]).period), EventKind::release);
       }},
      {"coco_velocity_after", [](P) { return coco_orbit().impact.velocity_after; }},
      {"coco_phase", [](P) { return coco_orbit().impact.instant.phase; }},
      {"coco_displacement", [](P) { return coco_orbit().at_pi.displacement.front(); }},
      {"coco_velocity", [](P) { return coco_orbit().at_pi.velocity.front(); }},
      {"grazing_amplitude", grazing_amplitude},
      {"chatter_limit",
       [](P p) { return first_time_of(events_to(ball_of(p), 10.0), EventKind::stick); }},
      {"chatter_limit_below_a_ceiling",
       [](P p) {
         Scene scene = ball_of(p);
         scene.stops.push_back({1, Side::upper, p["ceiling"]});
         return first_time_of(events_to(scene, 10.0), EventKind::stick);
       }},
      {"first_impact",
       [](P p) { return first_time_of(events_to(ball_of(p), 10.0), EventKind::impact); }},
      {"bar_contact_time", [](P) { return limit_of_contact_time(); }},
      {"bar_rate", [](P) { return rate_of_contact_time(); }},
      {"bar_end_of_contact",
       [](P p) {
         const Scene scene =
             bar(static_cast<int>(p["elements"]), static_cast<int>(p["per_length"]));
         return p["start"] + first_time_of(events_to(scene, 0.0015), EventKind::release);
       }},
      {"bar_impulse",
       [](P p) {
         return impulse_of_the_wall(static_cast<int>(p["elements"]),
                                    static_cast<int>(p["per_length"]));
       }},
  };
  return functions;
}

// One row each: id,source,quantity,parameters,printed,tolerance,kind,limited_by.
inline std::vector<PublishedResult> single_results(const std::string &folder) {
  const std::string name = folder + "/published.csv";
  std::ifstream file = opened(name);
  std::vector<PublishedResult> results;
  for (const auto &cells : read_rows(file, name, 8)) {
    const auto function = quantities().find(cells[2]);
    if (function == quantities().end())
      throw std::runtime_error(
          fmt::format("{}: '{}' is not a quantity known here", name, cells[2]));
    const auto compute = [f = function->second, p = read_parameters(name, cells[3])] {
      return f(p);
    };
    results.push_back({cells[0], cells[1], cells[2] + " " + cells[3], cells[4],
                       number_in(name, cells[4]), number_in(name, cells[5]), cells[7], compute});
  }
  return results;
}

// A point of the curves of period doublings of Ghosh and Simpson: x'' + 0.04 x' + x = F cos(omega
// t), x <= 1, r = 0.9, one impact in two forcing periods, a multiplier at -1.
struct VividPoint {
  std::string curve, line, printed_amplitude;
  double omega, amplitude, multiplier, speed, time;
  double restitution = 0.9;

  OneImpactOrbit orbit_at(double forcing) const {
    return one_impact_orbit(one_mass(0.04, forcing, omega, restitution, 1.0), 2, time, speed);
  }
  // That of the orbit with the printed impact speed.
  double amplitude_of_speed() const {
    return zero_near([this](double forcing) { return orbit_at(forcing).speed() - speed; },
                     amplitude, 1e-7);
  }
  double amplitude_of_doubling() const {
    return zero_near(
        [this](double forcing) { return orbit_at(forcing).doubling_multiplier() + 1.0; }, amplitude,
        1e-7);
  }
};

inline std::vector<VividPoint> vivid_points(const std::string &folder) {
  const std::string name = folder + "/published_vivid.csv";
  std::ifstream file = opened(name);
  std::vector<VividPoint> points;
  for (const auto &cells : read_rows(file, name, 7)) {
    const auto number = [&](std::size_t i) { return number_in(name, cells[i]); };
    points.push_back(
        {cells[0], cells[1], cells[3], number(2), number(3), number(4), number(5), number(6)});
  }
  return points;
}

// Two results a point: the amplitude of the orbit with the printed impact speed, and that of the
// bifurcation itself. Their Newton's method and their bisections for times end at 1e-10; that for
// the multiplier ends at 1e-5, which moves the amplitude by up to 1.1e-5.
inline std::vector<PublishedResult> vivid_results(const std::string &folder) {
  std::vector<PublishedResult> results;
  for (const VividPoint &point : vivid_points(folder)) {
    const std::string id = fmt::format("{}:{}", point.curve, point.line);
    results.push_back(
        {id + "_orbit", "vivid",
         fmt::format("amplitude of the orbit, omega={:.6g} speed={:.6g}", point.omega, point.speed),
         point.printed_amplitude, point.amplitude, 1e-10, "theirs: Newton's method to 1e-10",
         [point] { return point.amplitude_of_speed(); }});
    results.push_back({id + "_doubling", "vivid",
                       fmt::format("amplitude of the period doubling, omega={:.6g}", point.omega),
                       point.printed_amplitude, point.amplitude, 1.2e-5,
                       "theirs: multiplier to 1e-5",
                       [point] { return point.amplitude_of_doubling(); }});
  }
  return results;
}

// An impact in a table of Siconos.
struct SiconosImpact {
  std::string table, line, printed_time;
  std::size_t impact;  // its number, from 1
  double time, velocity;
};

inline std::vector<SiconosImpact> siconos_impacts(const std::string &folder) {
  const std::string name = folder + "/published_siconos.csv";
  std::ifstream file = opened(name);
  std::vector<SiconosImpact> impacts;
  for (const auto &cells : read_rows(file, name, 5))
    impacts.push_back({cells[0], cells[1], cells[3],
                       static_cast<std::size_t>(number_in(name, cells[2])),
                       number_in(name, cells[3]), number_in(name, cells[4])});
  return impacts;
}

// The same impact of the library, every one resolved.
inline Event impact_of_library(const SiconosImpact &printed) {
  std::size_t count = 0;
  for (const Event &event : events_to(siconos_scene(printed.table), 10.0, true))
    if (event.kind == EventKind::impact && ++count == printed.impact) return event;
  throw std::runtime_error(printed.table + ": fewer impacts than printed");
}

// Siconos locates an impact where the gap is below some 3e-13: that error over the impact speed, in
// the time, is left by every impact and grows with the number of them.
inline double siconos_tolerance(const SiconosImpact &impact) {
  return 3e-13 / std::abs(impact.velocity) + 1e-15;
}

inline std::vector<PublishedResult> siconos_results(const std::string &folder) {
  std::vector<PublishedResult> results;
  for (const SiconosImpact &impact : siconos_impacts(folder))
    results.push_back({fmt::format("{}:{}", impact.table, impact.line), "siconos",
                       fmt::format("time of impact {}", impact.impact), impact.printed_time,
                       impact.time, siconos_tolerance(impact),
                       "theirs: gap at impact below 3e-13, over the speed",
                       [impact] { return impact_of_library(impact).time; }});
  return results;
}

}  // namespace published

// All of them, from the tables in `folder`.
inline std::vector<PublishedResult> published_results(const std::string &folder) {
  std::vector<PublishedResult> results = published::single_results(folder);
  for (auto &result : published::vivid_results(folder)) results.push_back(std::move(result));
  for (auto &result : published::siconos_results(folder)) results.push_back(std::move(result));
  return results;
}

}  // namespace vibro_impact::figures
