// Event-for-event comparison of a run with an event table of the 50-digit generator.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "table_reader.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace vibro_impact::testing {

struct TableRow {
  double time;
  int mass;
  std::string event;
  double velocity_before;
  std::string contact_mode;
};

// Throws std::runtime_error naming the table and what is wrong with it.
inline std::vector<TableRow> read_event_table(std::istream &file, const std::string &name) {
  using figures::number_in;
  std::vector<TableRow> rows;
  for (const auto &cells : figures::read_rows(file, name, 6)) {
    const double mass = number_in(name, cells[1]);
    if (!(mass >= 1.0 && mass <= 1e6) || mass != std::floor(mass))
      throw std::runtime_error(fmt::format("{}: '{}' is not a mass", name, cells[1]));
    rows.push_back({number_in(name, cells[0]), static_cast<int>(mass), cells[2],
                    number_in(name, cells[3]), cells[5]});
  }
  return rows;
}

inline std::vector<TableRow> read_event_table(const std::string &path) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error(path + ": cannot be read");
  return read_event_table(file, path);
}

struct Comparison {
  std::string difference;  // empty when the events agree one by one
  double worst_time = 0.0, worst_velocity = 0.0;
  std::size_t matched = 0, beyond_the_limit = 0;
};

// Walks both tables in step. The only rows of the reference that may have no counterpart are the
// impacts of a mass after the run handed its chatter over to the limit: those between its last
// resolved impact and its stick. The only events of the run that may have none are the impacts of
// a completing chatter slower than 1e-6, which the generator's tables leave out.
inline Comparison compare(const std::vector<Event> &events,
                          const std::vector<TableRow> &reference) {
  Comparison result;
  std::size_t row = 0;
  const auto sticks_next = [&](std::size_t i, int mass) {
    while (i < reference.size() && reference[i].event == "impact" && reference[i].mass == mass) ++i;
    return i < reference.size() && reference[i].event == "stick" && reference[i].mass == mass;
  };
  for (const Event &event : events) {
    const bool left_out = event.kind == EventKind::impact && std::abs(event.velocity_before) < 1e-6;
    if (event.kind == EventKind::stick)
      while (row < reference.size() && reference[row].event == "impact" &&
             reference[row].mass == event.mass && sticks_next(row, event.mass)) {
        ++row;
        ++result.beyond_the_limit;
      }
    if (row == reference.size()) {
      result.difference = fmt::format("spurious {} of mass {} at {:.17g}", name(event.kind),
                                      event.mass, event.time);
      return result;
    }
    const TableRow &expected = reference[row];
    if (left_out && !(expected.event == "impact" && std::abs(expected.velocity_before) < 1e-6))
      continue;
    if (expected.event != name(event.kind) || expected.mass != event.mass ||
        expected.contact_mode != contact_mode_name(event.held) ||
        std::abs(expected.time - event.time) > 1e-6) {
      result.difference = fmt::format(
          "{} of mass {} at {:.17g} (mode {}) where the reference has {} of mass {} at {:.17g} "
          "(mode {})",
          name(event.kind), event.mass, event.time, contact_mode_name(event.held), expected.event,
          expected.mass, expected.time, expected.contact_mode);
      return result;
    }
    result.worst_time = std::max(result.worst_time, std::abs(event.time - expected.time));
    if (event.kind == EventKind::impact)
      result.worst_velocity = std::max(result.worst_velocity,
                                       std::abs(event.velocity_before - expected.velocity_before));
    ++result.matched;
    ++row;
  }
  if (row < reference.size())
    result.difference = fmt::format("missing {} of mass {} at {:.17g}", reference[row].event,
                                    reference[row].mass, reference[row].time);
  return result;
}

}  // namespace vibro_impact::testing
