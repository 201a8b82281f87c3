// Samples at the times of the events of a run.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "vibro_impact/vibro_impact.hpp"

namespace vibro_impact::testing {

// Samples at the first event of each time, which have the motion before it. Impacts at the start,
// and those whose speed is small beside the rounding of their time, are left out.
struct SamplesAtEvents : Recorder {
  std::vector<Event> events = {};
  std::size_t taken = 0;
  std::vector<double> velocities = {};  // of all masses
  double fastest = 0.0;
  std::string broken = {};

  explicit SamplesAtEvents(const std::vector<Event> &all) {
    for (const Event &event : all)
      if (event.time > (events.empty() ? 0.0 : events.back().time)) events.push_back(event);
  }
  double next_time() const override {
    return taken < events.size() ? events[taken].time : infinity;
  }
  void sample(const Moment &moment) override {
    const Event &event = events[taken++];
    const double before = event.velocity_before, sampled = moment.velocity(event.mass);
    for (int mass = 1; mass <= moment.masses(); ++mass) {
      velocities.push_back(moment.velocity(mass));
      fastest = std::max(fastest, std::abs(velocities.back()));
    }
    if (std::abs(before) > 1e-6 * fastest && !(std::copysign(1.0, before) * sampled > 0.0) &&
        broken.empty())
      broken = fmt::format("sampled at the impact at {} with {} before it, has {}", event.time,
                           before, sampled);
  }
};

}  // namespace vibro_impact::testing
