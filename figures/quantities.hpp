// Quantities read off a run: events, counts, times, extremes and sticking phases.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "reference/numbers/panels.hpp"
#include "reference/scenes/paper_scenes.hpp"
#include "vibro_impact/analysis/locate.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace vibro_impact::figures {

struct Range {
  double lowest = std::numeric_limits<double>::infinity();
  double highest = -std::numeric_limits<double>::infinity();

  void include(double value) {
    lowest = std::min(lowest, value);
    highest = std::max(highest, value);
  }
};

// The displacement of one of two masses at a sample.
inline double displacement(const SampleRecorder &samples, std::size_t sample, int mass) {
  return samples.displacements[2 * sample + static_cast<std::size_t>(mass - 1)];
}

inline Range range_of(const SampleRecorder &samples, int mass) {
  Range range;
  for (std::size_t i = 0; i < samples.times.size(); ++i)
    range.include(displacement(samples, i, mass));
  return range;
}

// Events of a scene from its own start, from time `from` to `until`.
inline std::vector<Event> events_of(const Scene &scene, double from, double until,
                                    const RunOptions &options = {}) {
  EventRecorder recorder(from);
  require_complete(simulate(scene, until, options, recorder));
  return recorder.events;
}

// Number of times at which a mass comes to rest while the other one sticks.
inline double dual_sticks(const Scene &scene, double from, double until) {
  const std::vector<Event> events = events_of(scene, from, until);
  return static_cast<double>(std::ranges::count_if(events, [](const Event &event) {
    return event.kind == EventKind::stick && contact_mode_name(event.held) == "1+2";
  }));
}

// The sticking phases of a mass in four forcing periods of the motion that a scene settles to.
// Motions of period 1, 2 and 4 give the same count in every window.
inline int settled_sticking_phases(const Scene &scene, int mass) {
  return sticking_phases(scene, mass, paper::figure4_settling_periods, 4);
}

// The same of the motion followed to this scene from a motion that settles at another frequency.
inline int followed_sticking_phases(Scene scene, int mass, const MotionState &settled) {
  scene.displacement = settled.displacement;
  scene.velocity = settled.velocity;
  return settled_sticking_phases(scene, mass);
}

}  // namespace vibro_impact::figures
