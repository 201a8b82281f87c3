// Tables of the drivers of the figures, and the true events to compare them with.
#pragma once

#include <cstdlib>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "events.hpp"
#include "reference/scenes/paper_scenes.hpp"
#include "reference/truth/event_reader.hpp"
#include "reference/truth/table_reader.hpp"

namespace vibro_impact::testing {

inline truth::Rows rows_in(const std::string &table) {
  std::istringstream text(table);
  return truth::read_rows(text, "table");
}

// Runs the driver of a figure. Returns the folder of its tables, which is that of one test in this
// build, since several tests run at once. Throws std::runtime_error if the driver fails.
inline std::string tables_of(const std::string &figure, const std::string &test) {
  const std::string folder = PROGRAM_DIR "/../tables_of_tests/" + test;
  const std::string command = "'" PROGRAM_DIR "/" + figure + "' --output '" + folder + "'";
  if (std::system(command.c_str()) != 0) throw std::runtime_error(command + ": failed");
  return folder;
}

inline std::vector<Event> true_events(const std::string &scene) {
  return truth::read_event_table(REFERENCE_DIR "/" + scene + "_events.csv");
}

// Each mass of the paper's scenes has one stop.
inline double stop_position(const Scene &scene, int mass) {
  return scene.stops[static_cast<std::size_t>(mass - 1)].position;
}

inline bool holds(const Held &held, int mass) {
  const auto i = static_cast<std::size_t>(mass - 1);
  return i < held.size() && held[i] != 0;
}

}  // namespace vibro_impact::testing
