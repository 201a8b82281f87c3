// Runs of the paper's scenes as the tests of its figures read them: events and samples.
//
// Kinds of the numbers compared with: printed (in the paper), derived (a formula), computed (by the
// 50-digit generator in reference/, see key_numbers.csv).
#pragma once

#include <limits>
#include <vector>

#include "reference/scenes/paper_scenes.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace vibro_impact::testing {

// Event times are compared with computed ones to 1e-9. The library keeps them to about 1e-12 of a
// unit of time per forcing period; what is guarded here is the motion, not the last digits.
constexpr double same_time = 1e-9;

// Samples lie 0.005 apart, an extreme at most half of that from one; with |x''| < 1 there it is
// missed by at most 0.0025^2 / 2 = 3.2e-6.
constexpr double sampling_step = 0.005, sampled_extreme = 4e-6;

inline std::vector<Event> events_of(
    const Scene &scene, double from, double until,
    double resolve_chatter = std::numeric_limits<double>::infinity()) {
  RunOptions options;
  options.resolve_chatter = resolve_chatter;
  EventRecorder recorder{from};
  require_complete(simulate(scene, until, options, recorder));
  return recorder.events;
}

inline std::vector<Event> select(const std::vector<Event> &events, EventKind kind, int mass,
                                 double from = 0.0,
                                 double to = std::numeric_limits<double>::infinity()) {
  std::vector<Event> selected;
  for (const Event &event : events)
    if (event.kind == kind && event.mass == mass && event.time >= from && event.time <= to)
      selected.push_back(event);
  return selected;
}

inline SampleRecorder sampled(const Scene &scene, const paper::AxisBox &box) {
  SampleRecorder samples;
  samples.from = box.from;
  samples.to = box.to;
  samples.every = sampling_step;
  require_complete(simulate(scene, box.to, {}, samples));
  return samples;
}

}  // namespace vibro_impact::testing
