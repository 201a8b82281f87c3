// Figures read these off runs: events, counts, extremes, displacements across a window, sticking
// phases, and the records of Figure 3.
#pragma once

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

#include "reference/numbers/panels.hpp"
#include "reference/scenes/paper_scenes.hpp"
#include "vibro_impact/analysis/sweep.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace vibro_impact::figures {

struct Range {
  double lowest = infinity;
  double highest = -infinity;

  void include(double value) {
    lowest = std::min(lowest, value);
    highest = std::max(highest, value);
  }
};

// The first and the last of each run of neighbours below `count` for which `holds` is true.
template <class Predicate>
std::vector<std::pair<std::size_t, std::size_t>> runs_where(const Predicate &holds,
                                                            std::size_t count) {
  std::vector<std::pair<std::size_t, std::size_t>> runs;
  for (std::size_t i = 0; i < count; ++i) {
    if (!holds(i)) continue;
    if (runs.empty() || runs.back().second + 1 != i) runs.emplace_back(i, i);
    runs.back().second = i;
  }
  return runs;
}

// The distinct ones among `values`, sorted: those that agree to 1e-6 of their size, as the impacts
// of a periodic motion do from period to period, count as one.
inline std::vector<double> distinct(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const auto same = [](double a, double b) { return std::abs(a - b) <= 1e-6 * std::abs(a); };
  values.erase(std::unique(values.begin(), values.end(), same), values.end());
  return values;
}

// Frequencies from 0.25 to 0.7, both included, at equal distances.
inline Grid grid_of_figure3(std::size_t count) {
  const paper::AxisBox box = paper::panel("figure3a");
  return {paper::figure3(box.from), {{"omega", box.from, box.to, count}}};
}

// Each motion from rest, with its chatter impacts down to slowest_impact_shown.
inline const RecordOptions recorded_of_figure3{
    .settle = {.longest = paper::figure3_settling_periods},
    .impacts = true,
    .slowest = paper::slowest_impact_shown};

// The displacement of one of two masses at a sample.
double displacement(const SampleRecorder &samples, std::size_t sample, int mass);

Range range_of(const SampleRecorder &samples, int mass);

// Events of a scene from its own start, from time `from` to `until`.
std::vector<Event> events_of(const Scene &scene, double from, double until,
                             const RunOptions &options = {});

// Number of times at which a mass comes to rest while the other one sticks.
double dual_sticks(const Scene &scene, double from, double until);

// The sticking phases of a mass in four forcing periods of the motion that a scene settles to.
// Motions of period 1, 2 and 4 give the same count in every window.
int settled_sticking_phases(const Scene &scene, int mass);

// The same of the motion followed to this scene from a motion that settles at another frequency.
int followed_sticking_phases(Scene scene, int mass, const MotionState &settled);

// A run shown as displacement against time resolves all chatter that can be seen.
inline const RunOptions all_visible_chatter{.limit_below_speed = paper::slowest_impact_shown};

// The samples of both masses as a table t, x1, x2.
Table displacement_table(const SampleRecorder &samples);

// The displacements of a scene across the window of a panel.
Table displacements(const Scene &scene, const paper::AxisBox &box, double every);

// The impacts across the window of a panel: when, of which mass, and how fast.
Table impacts(const Scene &scene, const paper::AxisBox &box);

// The parameters of the scenes that a figure shows, one row per panel.
Table parameters(const std::vector<Scene> &scenes);

// The sticking phases of one mass, counted from 1, and the times between them: at uniform times, at
// the stick and at the release the hold force on it (F_p of Eq. 12, rebuilt, and Eq. 13) and the
// motion of another mass.
struct StickingPhaseRecorder : Recorder {
  struct Row {
    int phase;              // between two phases, the earlier one; 0 before the first
    std::string_view kind;  // stick, release, orbit from one to the other, or free between phases
    double time;            // within the forcing period
    double force;  // zero at a release at a root of the force; NaN at any other, and if free
    double x = 0.0, v = 0.0;  // of the other mass
  };
  int mass, other;  // other = 0: none
  double from, to, every;
  std::vector<Row> rows = {};
  int phase = 0;
  std::size_t asked = 0;

  StickingPhaseRecorder(int of_mass, int other_mass, double from_time, double to_time,
                        double every_time)
      : mass(of_mass), other(other_mass), from(from_time), to(to_time), every(every_time) {
  }
  double next_time() const override {
    return sample_time(from, to, every, asked);
  }
  void sample(const Moment &moment) override;
  void event(const Event &event, const Moment &moment) override;
  void add(std::string_view kind, double force, const Moment &moment);
};

}  // namespace vibro_impact::figures
