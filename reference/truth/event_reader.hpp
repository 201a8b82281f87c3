// The event tables of the 50-digit generator, and a run as such a table.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "case.hpp"
#include "table_reader.hpp"
#include "vibro_impact/record.hpp"

namespace vibro_impact::truth {

// The event in the columns time, mass, event, velocity_before, velocity_after and contact_mode of a
// row, of which `first` is the first. Throws std::runtime_error naming the table and the cell.
inline TrueEvent event_in(const std::string &name, const std::vector<std::string> &cells,
                          std::size_t first = 0) {
  const std::string &mass_cell = cells[first + 1];
  const double mass = number_in(name, mass_cell);
  if (!(mass >= 1.0 && mass <= 1e6) || mass != std::floor(mass))
    throw std::runtime_error(fmt::format("{}: '{}' is not a mass", name, mass_cell));
  return {0,
          number_in(name, cells[first]),
          static_cast<int>(mass),
          cells[first + 2],
          number_in(name, cells[first + 3]),
          cells[first + 5]};
}

// Throws std::runtime_error naming the table and what is wrong with it.
inline std::vector<TrueEvent> read_event_table(const std::string &path) {
  std::vector<TrueEvent> events;
  for (const auto &cells : read_rows(path, 6)) events.push_back(event_in(path, cells));
  return events;
}

// The events of several cases, named in a column before the others.
using EventTables = std::map<std::string, std::vector<TrueEvent>>;

// Throws std::runtime_error as above.
inline EventTables read_event_tables(const std::string &path) {
  EventTables tables;
  for (const auto &cells : read_rows(path, 7)) tables[cells[0]].push_back(event_in(path, cells, 1));
  return tables;
}

inline std::vector<TrueEvent> as_truth(const std::vector<Event> &events) {
  std::vector<TrueEvent> rows;
  for (const Event &event : events)
    rows.push_back({event.instant.cycle, event.instant.phase, event.mass, name(event.kind),
                    event.velocity_before, contact_mode_name(event.held)});
  return rows;
}

}  // namespace vibro_impact::truth
