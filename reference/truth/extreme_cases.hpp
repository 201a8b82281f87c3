// The extreme cases, group by group, in the order of the stability figure: the rows of
// reference/tables/extreme_cases.csv.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "exact_events.hpp"
#include "scene_reader.hpp"

namespace vibro_impact::truth {

namespace detail {

// The formula of exact_events.hpp that a row names, with the numbers of its scene.
inline std::vector<Event> exact_events(const std::string &formula, const Case &row) {
  const Scene &scene = row.scene;
  const double stop = scene.stops.front().position, r = scene.restitution;
  if (formula == "nothing") return {};
  if (formula == "stick") return {event_at(0.0, 1, EventKind::stick)};
  if (formula == "bounces")
    return bounces(scene.displacement[0], stop, r, row.until, scene.masses());
  if (formula == "rattling") return rattling(stop, scene.velocity[0], r, row.until);
  if (formula == "touches")  // half a period after the start, or a whole one if that is a touch
    return touches((scene.displacement[0] < 0.0 ? 1 : 2) * std::numbers::pi_v<Extended>, row.until);
  if (formula == "periodic impacts") {
    const double period = 2.0 * std::numbers::pi / scene.omega;
    return periodic_impacts(scene.amplitude[0], scene.omega, r, stop,
                            std::llround(row.from / period), std::llround(row.until / period));
  }
  throw std::runtime_error(row.name + ": '" + formula + "' is no formula of exact_events.hpp");
}

}  // namespace detail

// Throws std::runtime_error naming the table and what is wrong with it.
inline std::vector<Case> extreme_cases() {
  const std::string table = REFERENCE_DIR "/extreme_cases.csv";
  std::vector<Case> cases;
  for (const Row &row : read_rows(table)) {
    Case &one = cases.emplace_back();
    one.name = row.cell("case");
    one.group = row.cell("group");
    one.from = row.number("from");
    one.until = row.number("until");
    one.slowest_impact = row.number("slowest_impact");
    one.scene = scene_in(row);
    one.truth = Truth{word_in(row.place(), row.cell("truth"), truth_words)};
    if (one.truth != Truth::digits) one.events = detail::exact_events(row.cell("formula"), one);
  }
  return cases;
}

}  // namespace vibro_impact::truth
