// The event tables of the 50-digit generator.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "case.hpp"
#include "table_reader.hpp"

namespace vibro_impact::truth {

namespace detail {

// Each of the two throws std::runtime_error naming `place` and the cell.

inline int mass_in(const std::string &place, const std::string &cell) {
  const double mass = number_in(place, cell);
  if (!(mass >= 1.0 && mass <= 1e6) || mass != std::floor(mass))
    throw std::runtime_error(fmt::format("{}: '{}' is not a mass", place, cell));
  return static_cast<int>(mass);
}

// A table names the masses that are held, and not the sides of their stops: +1 stands for either
// side. The list ends at the last mass that is held.
inline Held held_in(const std::string &place, const std::string &cell) {
  Held held;
  std::istringstream masses(cell == "-" ? "" : cell);
  for (std::string mass; std::getline(masses, mass, '+');) {
    const auto count = static_cast<std::size_t>(mass_in(place, mass));
    held.resize(std::max(held.size(), count), 0);
    held[count - 1] = 1;
  }
  return held;
}

// The event in the columns time, mass, event, velocity_before, velocity_after and contact_mode, of
// which `first` is the first.
inline Event event_in(const std::string &place, const Row &row, std::size_t first = 0) {
  Event event = event_at(number_in(place, row[first]), mass_in(place, row[first + 1]),
                         kind_in(place, row[first + 2]), number_in(place, row[first + 3]));
  event.velocity_after = number_in(place, row[first + 4]);
  event.held = held_in(place, row[first + 5]);
  return event;
}

}  // namespace detail

// Throws std::runtime_error naming the table, the line and what is wrong with it.
inline std::vector<Event> read_event_table(const std::string &path) {
  std::vector<Event> events;
  for (const Row &row : read_rows(path, 6))
    events.push_back(detail::event_in(line_of(path, events.size()), row));
  return events;
}

// The events of several cases, named in a column before the others.
using EventTables = std::map<std::string, std::vector<Event>>;

// Throws std::runtime_error as above.
inline EventTables read_event_tables(const std::string &path) {
  EventTables tables;
  std::size_t index = 0;
  for (const Row &row : read_rows(path, 7))
    tables[row[0]].push_back(detail::event_in(line_of(path, index++), row, 1));
  return tables;
}

}  // namespace vibro_impact::truth
