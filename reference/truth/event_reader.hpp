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

inline Event event_in(const Row &row) {
  Event event = event_at(row.number("time"), mass_in(row.place(), row.cell("mass")),
                         kind_in(row.place(), row.cell("event")), row.number("velocity_before"));
  event.velocity_after = row.number("velocity_after");
  event.held = held_in(row.place(), row.cell("contact_mode"));
  return event;
}

}  // namespace detail

// Throws std::runtime_error naming the table, the line and what is wrong with it.
inline std::vector<Event> read_event_table(const std::string &path) {
  std::vector<Event> events;
  for (const Row &row : read_rows(path)) events.push_back(detail::event_in(row));
  return events;
}

// The events of several cases.
using EventTables = std::map<std::string, std::vector<Event>>;

// By the names of the cases in the column `named`. Throws std::runtime_error as above.
inline EventTables read_event_tables(const std::string &path, const std::string &named) {
  EventTables tables;
  for (const Row &row : read_rows(path)) tables[row.cell(named)].push_back(detail::event_in(row));
  return tables;
}

}  // namespace vibro_impact::truth
