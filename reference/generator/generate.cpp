// Writes the reference tables: the events of the paper's scenes and its key numbers. See
// reference/README.md.
#include "reference/truth/extreme_cases.hpp"
#include "tables.hpp"

#include <exception>
#include <fstream>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using namespace vibro_impact_reference;

/// The events of those extreme cases whose truth is the generator's, one table.
std::string extremes_table() {
  std::string table = std::string("case,") + columns;
  for (const auto &extreme : vibro_impact::truth::extreme_cases()) {
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

// --- Error against run time -------------------------------------------------------------------

/// An excerpt of the motion of a scene of the paper: where it starts and ends.
struct Excerpt {
  std::string name, scene;
  double from, until;
};

/// Two whole motions of ten forcing periods from rest, and three pieces of Figure 2 after three of
/// its periods: a flight with the impact that ends it, a chatter sequence of mass 2 with the stick
/// that ends it, and the sticking phase after it with its release.
std::vector<Excerpt> excerpts() {
  const auto ten_periods = [](const char *scene) {
    return forcing_periods(10.0, vibro_impact::paper::scene_named(scene).scene);
  };
  return {{"figure2", "figure2", 0.0, ten_periods("figure2")},
          {"figure4", "figure4a", 0.0, ten_periods("figure4a")},
          {"flight", "figure2", 117.5, 119.5},
          {"chatter", "figure2", 121.0, 125.5},
          {"sticking", "figure2", 125.5, 133.0}};
}

struct ExcerptRun {
  State start;
  std::vector<Event> events;
};

/// The state at the start is rounded to double before the 50-digit run goes on from it, so that a
/// run in double starts from exactly the same numbers.
ExcerptRun run_of(const Excerpt &excerpt) {
  Scene scene = in_digits(vibro_impact::paper::scene_named(excerpt.scene).scene, excerpt.from);
  Run run;
  State state = initial_state(scene, {}, run);
  advance(scene, state, run);
  run.events.clear();
  for (Real &x : state.x) x = Real(static_cast<double>(x));
  for (Real &v : state.v) v = Real(static_cast<double>(v));
  state.time = scene.end_time;
  const State start = state;
  scene.end_time = Real(excerpt.until);
  advance(scene, state, run);
  return {start, run.events};
}

/// The start of every excerpt, exactly doubles; held masses as 0 or 1.
std::string work_precision_states() {
  std::ostringstream table;
  table << "problem,scene,from,until,x1,x2,v1,v2,held1,held2\n";
  for (const Excerpt &excerpt : excerpts()) {
    const State start = run_of(excerpt).start;
    table << excerpt.name << ',' << excerpt.scene << ',' << Real(excerpt.from).str(17) << ','
          << Real(excerpt.until).str(17);
    for (const Real &x : start.x) table << ',' << x.str(17);
    for (const Real &v : start.v) table << ',' << v.str(17);
    for (const auto &stop : start.stuck_on) table << ',' << stop.has_value();
    table << '\n';
  }
  return table.str();
}

/// The events of the excerpts that do not begin the tables of their scenes.
std::string work_precision_events() {
  std::string table = std::string("problem,") + columns;
  for (const Excerpt &excerpt : excerpts())
    if (excerpt.from > 0.0)
      table += event_rows(run_of(excerpt).events, Vector(2, kept_speed), excerpt.name + ",");
  return table;
}

constexpr const char *tables =
    "figure2, figure4a, figure4b, figure5a, figure5b, figure5c, checked_numbers, extremes, "
    "work_precision_states, work_precision_events, chain10, chain200, number:<id of a key number>";

/// Throws std::invalid_argument if there is no table or scene of that name.
std::string table_named(const std::string &name) {
  if (name == "checked_numbers") return filled_table();
  if (name.starts_with("number:")) return digits_of(name.substr(7));
  if (name == "extremes") return extremes_table();
  if (name == "work_precision_states") return work_precision_states();
  if (name == "work_precision_events") return work_precision_events();
  if (name == "chain10") return chain_table(10);
  if (name == "chain200") return chain_table(200);
  for (const auto &[scene_name, scene, until, inferred] : vibro_impact::paper::named_scenes())
    if (name == scene_name)
      return events_table(simulate(in_digits(scene, until)).events, scene.mass.size());
  throw std::invalid_argument("table '" + name + "': must be one of " + tables);
}

}  // namespace

int main(int argc, char **argv) try {
  if (argc != 3)
    throw std::invalid_argument(
        std::string("usage: reference-generate <table> <out.csv or ->, with table one of ") +
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
