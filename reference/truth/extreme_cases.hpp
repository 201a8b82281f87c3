// The extreme cases, group by group, in the order of the stability figure: the rows of
// reference/tables/extreme_cases.csv.
#pragma once

#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "exact_events.hpp"
#include "table_reader.hpp"

namespace vibro_impact::truth {

namespace detail {

// Numbers with a blank between them; 0.5*200 stands for two hundred of them.
inline std::vector<double> numbers_in(const std::string &table, const std::string &cell) {
  std::vector<double> numbers;
  std::istringstream words(cell);
  for (std::string word; words >> word;) {
    const auto star = word.find('*');
    const double times = star == std::string::npos ? 1.0 : number_in(table, word.substr(star + 1));
    numbers.insert(numbers.end(), static_cast<std::size_t>(times),
                   number_in(table, word.substr(0, star)));
  }
  return numbers;
}

// Mass, side and position of each.
inline std::vector<Stop> stops_in(const std::string &cell) {
  std::vector<Stop> stops;
  std::istringstream words(cell);
  std::string side;
  for (Stop stop; words >> stop.mass >> side >> stop.position; stops.push_back(stop))
    stop.side = side == "lower" ? Side::lower : Side::upper;
  return stops;
}

// The formula of exact_events.hpp that a row names, with the numbers of its scene.
inline std::vector<Event> exact_events(const std::string &formula, const Case &of) {
  const Scene &scene = of.scene;
  const double stop = scene.stops.front().position, r = scene.restitution;
  if (formula == "nothing") return {};
  if (formula == "stick") return {event_at(0.0, 1, EventKind::stick)};
  if (formula == "bounces")
    return bounces(scene.displacement[0], stop, r, of.until, scene.masses());
  if (formula == "rattling") return rattling(stop, scene.velocity[0], r, of.until);
  if (formula == "touches")  // half a period after the start, or a whole one if that is a touch
    return touches((scene.displacement[0] < 0.0 ? 1 : 2) * std::numbers::pi_v<Extended>, of.until);
  if (formula == "periodic impacts") {
    const double period = 2.0 * std::numbers::pi / scene.omega;
    return periodic_impacts(periodic_impact(scene.amplitude[0], scene.omega, r, stop),
                            std::llround(of.from / period), std::llround(of.until / period));
  }
  throw std::runtime_error(of.name + ": '" + formula + "' is no formula of exact_events.hpp");
}

}  // namespace detail

// Throws std::runtime_error naming the table and what is wrong with it.
inline std::vector<Case> extreme_cases() {
  const std::string table = REFERENCE_DIR "/extreme_cases.csv";
  std::vector<Case> cases;
  for (const auto &cells : read_rows(table, 16)) {
    const auto numbers = [&](std::size_t column) {
      return detail::numbers_in(table, cells[column]);
    };
    const auto number = [&](std::size_t column) { return number_in(table, cells[column]); };
    Case &row = cases.emplace_back();
    row.name = cells[0];
    row.group = cells[1];
    row.from = number(4);
    row.until = number(5);
    row.slowest_impact = number(6);
    row.scene = {.mass = numbers(7),
                 .stiffness = numbers(8),
                 .beta = number(9),
                 .amplitude = numbers(10),
                 .omega = number(11),
                 .restitution = number(12),
                 .stops = detail::stops_in(cells[13]),
                 .displacement = numbers(14),
                 .velocity = numbers(15)};
    for (const Truth truth : {Truth::digits, Truth::exact, Truth::grazing})
      if (cells[2] == name(truth)) row.truth = truth;
    if (row.truth != Truth::digits) row.events = detail::exact_events(cells[3], row);
  }
  return cases;
}

}  // namespace vibro_impact::truth
