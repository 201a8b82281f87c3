// Writes the reference tables: the events of the paper's scenes and its key numbers. See
// reference/README.md.
#include "event_driven.hpp"
#include "event_table.hpp"
#include "in_digits.hpp"
#include "key_number_table.hpp"
#include "one_impact.hpp"
#include "reference/truth/degenerate_cases.hpp"
#include "reference/truth/extreme_cases.hpp"
#include "work_precision.hpp"

#include <exception>
#include <fstream>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using namespace vibro_impact_reference;

/// The events of those of these cases whose truth is the generator's, one table.
std::string cases_table(const std::vector<vibro_impact::truth::Case> &cases) {
  std::string table = std::string("case,") + columns;
  for (const auto &extreme : cases) {
    if (extreme.truth != vibro_impact::truth::Truth::digits) continue;
    const Scene scene = in_digits(extreme.scene, extreme.until);
    const std::vector<Event> events =
        simulate(scene, {.speed_floor = Real(extreme.slowest_impact)}).events;
    Vector slowest(scene.masses());
    for (const Event &e : events) {
      const Real speed = kept_speed * abs(e.velocity_before);
      if (speed > slowest[e.mass]) slowest[e.mass] = speed;
    }
    table += event_rows(events, slowest, extreme.name + ',');
  }
  return table;
}

/// The tables of the work-precision figure: states or events of every stretch.
std::string work_precision_table(bool states) {
  std::vector<StretchRun> runs;
  for (const Stretch &stretch : stretches()) runs.push_back(run(stretch));
  if (states) return states_table(runs);
  std::string table = std::string("problem,") + columns;
  for (const StretchRun &run : runs)
    if (run.stretch.from > 0.0)  // the others begin the tables of their scenes
      table += event_rows(run.events, Vector(2, kept_speed), run.stretch.name + ",");
  return table;
}

constexpr const char *tables =
    "figure2, figure4a, figure4b, figure5a, figure5b, figure5c, checked_numbers, extremes, "
    "degenerate, "
    "one_impact, work_precision_states, work_precision_events, number:<id of a key number>";

/// Throws std::invalid_argument if there is no table or scene of that name.
std::string table_named(const std::string &name) {
  if (name == "checked_numbers") return filled_table();
  if (name.starts_with("number:")) return digits_of(name.substr(7));
  if (name == "extremes") return cases_table(vibro_impact::truth::extreme_cases());
  if (name == "one_impact") return one_impact_table();
  if (name == "degenerate") return cases_table(vibro_impact::truth::degenerate_cases());
  if (name == "work_precision_states") return work_precision_table(true);
  if (name == "work_precision_events") return work_precision_table(false);
  for (const auto &[scene_name, scene, until] : vibro_impact::paper::named_scenes())
    if (name == scene_name)
      return events_table(simulate(in_digits(scene, until)).events, scene.mass.size());
  throw std::invalid_argument("table '" + name + "': must be one of " + tables);
}

}  // namespace

int main(int argc, char **argv) try {
  if (argc != 3)
    throw std::invalid_argument(
        std::string("usage: reference-generate <table> <out.csv or ->, with "
                    "table one of ") +
        tables);
  const std::string table = table_named(argv[1]);
  if (std::string(argv[2]) == "-") {
    std::cout << table;
    return 0;
  }
  std::ofstream file(argv[2]);
  file << table;
  file.close();
  if (!file) throw std::runtime_error(std::string("output '") + argv[2] + "': cannot be written");
  return 0;
} catch (const std::exception &error) {
  std::cerr << "reference-generate: " << error.what() << '\n';
  return 2;
}
