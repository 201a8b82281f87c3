// Writes the reference tables: the events of the paper's scenes and its key numbers. See README.md
// beside this file.
#include "event_driven.hpp"
#include "filled_table.hpp"
#include "key_numbers.hpp"
#include "reference/scenes/degenerate_cases.hpp"
#include "reference/scenes/extreme_cases.hpp"
#include "scenes.hpp"
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

/// Impacts slower than this are left out of a complete chatter's table; in the extreme scenes, of
/// any scale, slower than this part of the mass's fastest impact.
const Real kept_speed("1e-6");

std::string contact_mode(const std::vector<bool> &stuck) {
  std::string mode;
  for (std::size_t p = 0; p < stuck.size(); ++p) {
    if (stuck[p]) mode += (mode.empty() ? "" : "+") + std::to_string(p + 1);
  }
  return mode.empty() ? "-" : mode;
}

/// By Event::Kind.
constexpr const char *kind_names[] = {"impact", "stick", "release"};

/// Which events go to the table. Before a stick, the impacts of that mass slower than `slowest`
/// (per mass) are left out, back to the first faster one or to the first event of another mass: an
/// interrupted or incomplete chatter stays whole.
std::vector<bool> kept(const std::vector<Event> &events, const Vector &slowest) {
  std::vector<bool> keep(events.size(), true);
  for (std::size_t i = 0; i < events.size(); ++i) {
    if (events[i].kind != Event::Kind::stick) continue;
    for (std::size_t j = i; j-- > 0;) {
      const Event &earlier = events[j];
      if (earlier.kind != Event::Kind::impact || earlier.mass != events[i].mass) break;
      if (abs(earlier.velocity_before) >= slowest[earlier.mass]) break;
      keep[j] = false;
    }
  }
  return keep;
}

/// The rows of the kept events, each after `lead`.
std::string event_rows(const std::vector<Event> &events, const Vector &slowest,
                       const std::string &lead) {
  std::ostringstream table;
  const std::vector<bool> keep = kept(events, slowest);
  for (std::size_t i = 0; i < events.size(); ++i) {
    if (!keep[i]) continue;
    const Event &e = events[i];
    table << lead << e.time.str(30) << ',' << e.mass + 1 << ','
          << kind_names[static_cast<int>(e.kind)] << ',' << e.velocity_before.str(30) << ','
          << e.velocity_after.str(30) << ',' << contact_mode(e.stuck) << '\n';
  }
  return table.str();
}

const char *const columns = "time,mass,event,velocity_before,velocity_after,contact_mode\n";

std::string events_table(const std::vector<Event> &events, std::size_t masses) {
  return columns + event_rows(events, Vector(masses, kept_speed), "");
}

/// The events of those of these cases whose truth is the generator's, one table.
std::string cases_table(const std::vector<vibro_impact::extremes::Case> &cases) {
  std::string table = std::string("case,") + columns;
  for (const auto &extreme : cases) {
    if (extreme.truth != vibro_impact::extremes::Truth::digits) continue;
    const Scene scene = in_digits(extreme.scene, extreme.until);
    const std::vector<Event> events =
        simulate(scene, {.speed_floor = Real(extreme.slowest_impact)}).events;
    Vector slowest(scene.chain.masses.size());
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
    table += event_rows(run.events, Vector(2, kept_speed), run.stretch.name + ",");
  return table;
}

/// Throws std::invalid_argument if there is no table or scene of that name.
std::string table_named(const std::string &name) {
  if (name == "key_numbers") return filled_table("key_numbers.csv", key_numbers());
  if (name == "extremes") return cases_table(vibro_impact::extremes::all_cases());
  if (name == "degenerate") return cases_table(vibro_impact::extremes::degenerate_cases());
  if (name == "work_precision_states") return work_precision_table(true);
  if (name == "work_precision_events") return work_precision_table(false);
  const Scene scene = scene_named(name);
  return events_table(simulate(scene).events, scene.chain.masses.size());
}

}  // namespace

int main(int argc, char **argv) try {
  if (argc != 3) {
    std::cerr
        << "usage: generate <table> <out.csv>   with table one of figure2, figure4a, figure4b, "
           "figure5a, figure5b, figure5c, key_numbers, extremes, degenerate, "
           "work_precision_states, work_precision_events\n";
    return 2;
  }
  const std::string table = table_named(argv[1]);
  std::ofstream file(argv[2]);
  file << table;
  file.close();
  if (!file) throw std::runtime_error(std::string("output '") + argv[2] + "': cannot be written");
  return 0;
} catch (const std::exception &error) {
  std::cerr << "generate: " << error.what() << '\n';
  return 2;
}
