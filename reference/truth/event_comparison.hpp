// Event-for-event comparison of a run with the true events, mass by mass: which of two masses that
// hit at the same instant comes first in a table means nothing.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "case.hpp"
#include "vibro_impact/simulate.hpp"

namespace vibro_impact::truth {

struct Differences {
  std::string first;        // the first event without a counterpart; empty when all agree
  std::size_t matched = 0;  // events
  double time = 0.0;        // largest error in time
  double velocity = 0.0;    // largest error of an impact velocity
};

// The condition for two events to be the same.
struct Matching {
  // A difference in time by a thousandth of this means that two different events are compared.
  double period = 0.0;
  // Impacts of a chatter that completes may be missing in either table when they are slower than
  // this part of the mass's fastest impact: the generator leaves them out.
  double slow_impact = 1e-6;
  // Two runs are compared: they may differ, too, in the impact at which a chatter was handed over
  // to its limit.
  bool runs = false;
  // The contact modes must agree as well: where no two masses have events at one instant.
  bool contact_modes = false;
};

namespace detail {

template <class Row>
std::vector<Row> of_mass(const std::vector<Row> &rows, int mass) {
  std::vector<Row> selected;
  for (const Row &row : rows)
    if (row.mass == mass) selected.push_back(row);
  return selected;
}

// True when the impacts at `at` and after lead to a stick.
inline bool ends_in_stick(const std::vector<TrueEvent> &rows, std::size_t at) {
  while (at < rows.size() && rows[at].event == "impact") ++at;
  return at < rows.size() && rows[at].event == "stick";
}

// Steps through the events of one mass. In a chatter that completes, `truth` may have impacts after
// the run handed it over to its limit, and the run may have slow ones.
inline void compare_mass(const std::vector<TrueEvent> &events, const std::vector<TrueEvent> &truth,
                         const Clock &clock, const Matching &matching, Differences &result) {
  double fastest = 0.0;
  for (const TrueEvent &row : truth) fastest = std::max(fastest, std::abs(row.velocity_before));
  const auto slow = [&](const TrueEvent &row) {
    return row.event == "impact" && std::abs(row.velocity_before) < matching.slow_impact * fastest;
  };
  const auto differ = [&result](const char *what, const TrueEvent &row) {
    if (result.first.empty())
      result.first = fmt::format("{} {} of mass {} at {} periods + {:.17g}", what, row.event,
                                 row.mass, row.cycle, row.time);
  };
  std::size_t at = 0;
  for (std::size_t i = 0; i < events.size(); ++i) {
    const TrueEvent &event = events[i];
    if (event.event == "stick" && ends_in_stick(truth, at))
      while (truth[at].event == "impact") ++at;
    const bool may_be_missing = (matching.runs || slow(event)) && ends_in_stick(events, i);
    if (event.event == "impact" && may_be_missing &&
        (at == truth.size() || truth[at].event != "impact" || (slow(event) && !slow(truth[at]))))
      continue;
    if (at == truth.size() || truth[at].event != event.event) return differ("spurious", event);
    const TrueEvent &expected = truth[at++];
    const double error =
        std::abs(elapsed({expected.cycle, expected.time}, {event.cycle, event.time}, clock));
    if (!(error <= 1e-3 * matching.period)) return differ("misplaced", event);
    if (matching.contact_modes && event.contact_mode != expected.contact_mode)
      return differ("in another contact mode:", event);
    result.time = std::max(result.time, error);
    result.velocity =
        std::max(result.velocity, std::abs(event.velocity_before - expected.velocity_before));
    ++result.matched;
  }
  if (at < truth.size() && !(matching.runs && ends_in_stick(truth, at)))
    differ("missing", truth[at]);
}

}  // namespace detail

// Compares the events of a run of `scene` with the true ones.
inline Differences compare(const std::vector<TrueEvent> &events,
                           const std::vector<TrueEvent> &truth, const Scene &scene,
                           const Matching &matching) {
  Differences result;
  for (int mass = 1; mass <= scene.masses(); ++mass)
    detail::compare_mass(detail::of_mass(events, mass), detail::of_mass(truth, mass),
                         Clock(scene.omega), matching, result);
  return result;
}

// The fastest impact that may be reported for a touch, relative to the largest speed of the motion.
// A stop nearer by n roundings, s (1 - n eps), is hit with the speed sqrt(2 n eps) omega a, the
// time sqrt(2 n eps) / omega early. 5e-8 belongs to n = 5.6; three roundings are measured.
constexpr double grazing_speed = 5e-8;

// Compares the contacts of one mass, of unit speed and frequency, at a stop that its motion just
// touches. No double tells a touch from a miss or from a shallow hit. The run must be the exact one
// of a stop so near that no impact is faster than `grazing_speed`. An impact at that speed is early
// by as much, and makes all later touches earlier by the velocity that it takes from the motion,
// (1 + r) times that speed.
inline Differences compare_grazing(const std::vector<TrueEvent> &events,
                                   const std::vector<TrueEvent> &touches, const Scene &scene) {
  const auto allowed = [&](std::size_t touch) {
    return grazing_speed * (1.0 + (1.0 + scene.restitution) * static_cast<double>(touch));
  };
  Differences result;
  std::size_t at = 0;
  for (const TrueEvent &event : events) {
    const double time = time_of({event.cycle, event.time}, Clock(scene.omega));
    while (at < touches.size() && touches[at].time + allowed(at) < time) ++at;
    const double error = at < touches.size() ? std::abs(time - touches[at].time) : time;
    if (event.event != "impact" || !(error <= allowed(at)) ||
        !(std::abs(event.velocity_before) <= grazing_speed)) {
      result.first = fmt::format("spurious {} at {:.17g} with velocity {:.3g}", event.event, time,
                                 event.velocity_before);
      return result;
    }
    result.time = std::max(result.time, error);
    result.velocity = std::max(result.velocity, std::abs(event.velocity_before));
    ++result.matched;
    ++at;
  }
  return result;
}

}  // namespace vibro_impact::truth
