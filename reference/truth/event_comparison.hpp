// Event-for-event comparison of a run with the true events, mass by mass: which of two masses that
// hit at the same instant comes first in a table means nothing.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "case.hpp"

namespace vibro_impact::truth {

struct Differences {
  std::string first;        // the first event without a counterpart; empty when all agree
  std::size_t matched = 0;  // events
  double time = 0.0;        // largest error in time
  double velocity = 0.0;    // largest error of an impact velocity
};

// The condition for two lists of events to agree. In a complete chatter a run may go over to the
// limit at any impact, and the tables of the generator leave out the slowest impacts.
struct Matching {
  // Two events that are further apart in time are different events.
  double reach = 0.0;
  // In a complete chatter, impacts slower than this part of the mass's fastest impact may be
  // missing in the truth.
  double slow_impact = 1e-6;
  // Two runs are compared: any impacts of a complete chatter may be missing in either one.
  bool runs = false;
  // The contact modes must agree as well: where no two masses have events at one instant.
  bool contact_modes = false;
  // If not zero: from a start, stick or release on, the true impacts before the first one slower
  // than this are compared. No such impact may be missing, and no other impact is compared.
  double slowest_compared = 0.0;
};

namespace detail {

// Impacts of one mass, and the stick or release that follows them as the last event. The last
// stretch of a list has impacts only.
using Stretch = std::vector<Event>;

inline std::vector<Stretch> stretches_of(const std::vector<Event> &events, int mass) {
  std::vector<Stretch> stretches(1);
  for (const Event &event : events) {
    if (event.mass != mass) continue;
    stretches.back().push_back(event);
    if (changes_contact_mode(event.kind)) stretches.emplace_back();
  }
  return stretches;
}

inline bool is_complete_chatter(const Stretch &stretch) {
  return !stretch.empty() && stretch.back().kind == EventKind::stick;
}

// Drops the impacts behind the first `count` ones.
inline void keep_impacts(Stretch &stretch, std::ptrdiff_t count) {
  const auto end = std::ranges::find_if(stretch, changes_contact_mode, &Event::kind);
  if (count < end - stretch.begin()) stretch.erase(stretch.begin() + count, end);
}

// Drops the impacts that need no counterpart.
inline void drop_impacts(Stretch &run, Stretch &truth, const Matching &matching, double fastest) {
  const auto slower_than = [](double speed) {
    return [speed](const Event &event) { return std::abs(event.velocity_before) < speed; };
  };
  if (matching.slowest_compared > 0.0) {
    const auto compared =
        std::ranges::find_if(truth, slower_than(matching.slowest_compared)) - truth.begin();
    keep_impacts(truth, compared);
    keep_impacts(run, compared);
  } else if (is_complete_chatter(run) && is_complete_chatter(truth)) {
    const std::ptrdiff_t in_both = std::min(std::ssize(run), std::ssize(truth)) - 1;
    keep_impacts(truth, in_both);
    if (matching.runs ||
        std::all_of(run.begin() + in_both, run.end(), slower_than(matching.slow_impact * fastest)))
      keep_impacts(run, in_both);
  }
}

inline std::vector<Event> joined(const std::vector<Stretch> &stretches) {
  std::vector<Event> events;
  for (const Stretch &stretch : stretches)
    events.insert(events.end(), stretch.begin(), stretch.end());
  return events;
}

// Compares two lists of events one by one, from their beginning to the first difference.
inline void compare_one_by_one(const std::vector<Event> &run, const std::vector<Event> &truth,
                               const Clock &clock, const Matching &matching, Differences &result) {
  const auto differ = [&result](const char *how, const Event &event) {
    if (result.first.empty())
      result.first = fmt::format("{} {} of mass {} at t = {:.17g}", how, name(event.kind),
                                 event.mass, event.time);
  };
  for (std::size_t i = 0; i < std::max(run.size(), truth.size()); ++i) {
    if (i == run.size()) return differ("missing", truth[i]);
    if (i == truth.size() || run[i].kind != truth[i].kind) return differ("spurious", run[i]);
    const double error = std::abs(elapsed(truth[i].instant, run[i].instant, clock));
    if (!(error <= matching.reach)) return differ("misplaced", run[i]);
    if (matching.contact_modes &&
        contact_mode_name(run[i].held) != contact_mode_name(truth[i].held))
      return differ("in another contact mode:", run[i]);
    result.time = std::max(result.time, error);
    result.velocity =
        std::max(result.velocity, std::abs(run[i].velocity_before - truth[i].velocity_before));
    ++result.matched;
  }
}

}  // namespace detail

// Compares the events of a run of `scene` with the true ones.
inline Differences compare(const std::vector<Event> &events, const std::vector<Event> &truth,
                           const Scene &scene, const Matching &matching) {
  Differences result;
  for (int mass = 1; mass <= scene.masses(); ++mass) {
    std::vector<detail::Stretch> run = detail::stretches_of(events, mass),
                                 expected = detail::stretches_of(truth, mass);
    double fastest = 0.0;
    for (const Event &event : truth)
      if (event.mass == mass) fastest = std::max(fastest, std::abs(event.velocity_before));
    for (std::size_t i = 0; i < std::min(run.size(), expected.size()); ++i)
      detail::drop_impacts(run[i], expected[i], matching, fastest);
    detail::compare_one_by_one(detail::joined(run), detail::joined(expected), Clock(scene.omega),
                               matching, result);
  }
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
inline Differences compare_grazing(const std::vector<Event> &events,
                                   const std::vector<Event> &touches, const Scene &scene) {
  const auto allowed = [&](std::size_t touch) {
    return grazing_speed * (1.0 + (1.0 + scene.restitution) * static_cast<double>(touch));
  };
  Differences result;
  std::size_t touch = 0;
  for (const Event &event : events) {
    while (touch < touches.size() && touches[touch].time + allowed(touch) < event.time) ++touch;
    const double error =
        touch < touches.size() ? std::abs(event.time - touches[touch].time) : event.time;
    if (event.kind != EventKind::impact || !(error <= allowed(touch)) ||
        !(std::abs(event.velocity_before) <= grazing_speed)) {
      result.first = fmt::format("spurious {} at {:.17g} with velocity {:.3g}", name(event.kind),
                                 event.time, event.velocity_before);
      return result;
    }
    result.time = std::max(result.time, error);
    result.velocity = std::max(result.velocity, std::abs(event.velocity_before));
    ++result.matched;
    ++touch;
  }
  return result;
}

}  // namespace vibro_impact::truth
