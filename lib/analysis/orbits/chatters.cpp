#include "vibro_impact/analysis/chatters.hpp"

#include <algorithm>
#include <limits>
#include <map>

#include "simulation/for_analysis.hpp"
#include "vibro_impact/analysis/periodic_orbit.hpp"

namespace vibro_impact {

std::vector<Chatter> chatters_of(const std::vector<Event> &events) {
  std::vector<Chatter> chatters;
  std::map<int, std::size_t> under_way;  // the index of the chatter of a mass
  for (std::size_t k = 0; k < events.size(); ++k) {
    const Event &event = events[k];
    const auto latest = under_way.find(event.mass);
    if (event.kind != EventKind::impact) {
      if (latest == under_way.end()) continue;
      chatters[latest->second].complete = event.kind == EventKind::stick;
      under_way.erase(latest);
      continue;
    }
    if (latest == under_way.end() || event.falling == 0 ||
        chatters[latest->second].stop != event.stop) {
      under_way[event.mass] = chatters.size();
      chatters.push_back({event.stop, {}});
    }
    chatters[under_way[event.mass]].impacts.push_back(k);
  }
  return chatters;
}

int sticking_phases(const Scene &scene, int mass, int settling, int periods) {
  check(scene);
  require_mass(mass, scene.masses());
  require(settling >= 0, "settling = ", settling, ": must be non-negative");
  require(periods >= 1, "periods = ", periods, ": must be at least 1");
  require(periods <= std::numeric_limits<int>::max() - settling, "settling = ", settling,
          " and periods = ", periods, ": more than an int can count");
  const MotionState start = start_of(scene);
  EventRecorder recorder{time_of({settling, 0.0}, Clock(scene.omega))};
  const double until = time_after(scene, start, settling + periods);
  require_complete(simulate(scene, start, until, {}, recorder));
  return static_cast<int>(std::count_if(
      recorder.events.begin(), recorder.events.end(),
      [mass](const Event &event) { return event.kind == EventKind::stick && event.mass == mass; }));
}

}  // namespace vibro_impact
