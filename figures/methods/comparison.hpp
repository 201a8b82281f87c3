// The library beside what one would otherwise write, on the scene of Figure 2: a stiff spring in
// place of each stop (stiff_spring.hpp), and the plain event-driven scheme
// (plain_event_driven.hpp).
//
// The library stands for the rigid stops here. It is itself compared event for event with the
// 50-digit table reference/figure2_events.csv, to 1e-10 by the tests and 3e-13 as measured, far
// below every error shown.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include "plain_event_driven.hpp"
#include "reference/scenes/paper_scenes.hpp"
#include "stiff_spring.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace vibro_impact::figures {

constexpr double not_reached = std::numeric_limits<double>::quiet_NaN();

// The motion of the rigid stops well before the first chatter: three impacts of mass 2 at t = 1.53,
// 2.34 and 2.97, a fourth and slow one at 3.77, then free flight to 8.25.
constexpr double before_chatter = 6.0;
constexpr std::size_t first_impacts = 3;

struct Rigid {
  std::vector<double> impacts;  // times of the first three
  std::vector<double> state;    // x_1, x_2, x_1', x_2' at t = 6
};

inline Rigid rigid_motion(const Scene &scene) {
  EventRecorder recorder;
  const Outcome outcome = require_complete(simulate(scene, before_chatter, {}, recorder));
  Rigid rigid;
  for (std::size_t i = 0; i < first_impacts; ++i)
    rigid.impacts.push_back(recorder.events.at(i).time);
  for (double x : outcome.state.displacement) rigid.state.push_back(x);
  for (double v : outcome.state.velocity) rigid.state.push_back(v);
  return rigid;
}

// What the spring costs in accuracy: largest errors of the first three impact times and of the
// state at t = 6; NaN where the integration broke or an impact is missing.
struct SpringError {
  double time = 0.0, state = 0.0;
};

inline SpringError spring_error(const Scene &scene, const Rigid &rigid,
                                const stiff_spring::Options &options) {
  const auto result = stiff_spring::integrate(scene, before_chatter, options);
  SpringError error;
  for (std::size_t i = 0; i < first_impacts; ++i)
    error.time = i < result.contacts.size()
                     ? std::max(error.time, std::abs(result.contacts[i].time - rigid.impacts[i]))
                     : not_reached;
  if (!result.broke.empty())
    return {result.contacts.size() < first_impacts ? not_reached : error.time, not_reached};
  for (std::size_t i = 0; i < rigid.state.size(); ++i)
    error.state = std::max(error.state, std::abs(result.state[i] - rigid.state[i]));
  return error;
}

// Impacts of mass 1 from the start to the end of its first chatter, none left to the limit: the
// run ends at the accumulation time itself, so that the limit lies beyond its end.
inline std::vector<Event> resolved_chatter(const Scene &scene) {
  EventRecorder stick;
  require_complete(simulate(scene, Clock(scene.omega).period, {}, stick));
  const auto end = std::find_if(stick.events.begin(), stick.events.end(),
                                [](const Event &e) { return e.kind == EventKind::stick; });
  if (end == stick.events.end())
    throw std::runtime_error("no complete chatter in the first forcing period");
  RunOptions options;
  options.resolve_chatter = 0.0;
  EventRecorder recorder;
  // Until just before the mass comes to rest: room for every impact but not for their limit.
  require_complete(simulate(scene, end->time * (1.0 - 0x1p-47), options, recorder));
  std::erase_if(recorder.events,
                [&](const Event &e) { return e.kind != EventKind::impact || e.mass != end->mass; });
  return recorder.events;
}

// One run of the plain scheme beside the library's, from rest to `until`.
struct ThresholdRun {
  plain::Result plain;
  long long sticks = 0, releases = 0;
  // Largest errors in time; NaN unless sticks and releases are those of the library, one by one.
  double stick_error = 0.0, release_error = 0.0;
};

inline ThresholdRun with_threshold(const Scene &scene, double until,
                                   const std::vector<Event> &library,
                                   const plain::Options &options) {
  ThresholdRun run{plain::run(scene, until, options)};
  std::vector<Event> expected = library;
  std::erase_if(expected, [](const Event &e) { return e.kind == EventKind::impact; });
  std::size_t next = 0;
  bool same = true;
  for (const plain::PlainEvent &event : run.plain.events) {
    if (event.kind == EventKind::impact) continue;
    ++(event.kind == EventKind::stick ? run.sticks : run.releases);
    same = same && next < expected.size() && expected[next].kind == event.kind &&
           expected[next].mass == event.mass;
    if (!same) continue;
    double &error = event.kind == EventKind::stick ? run.stick_error : run.release_error;
    error = std::max(error, std::abs(event.time - expected[next++].time));
  }
  if (!same || next != expected.size()) run.stick_error = run.release_error = not_reached;
  return run;
}

}  // namespace vibro_impact::figures
