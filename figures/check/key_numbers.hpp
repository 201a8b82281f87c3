// The key numbers as the library computes them, by their symbols in
// reference/tables/key_numbers.csv.
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "figures/quantities.hpp"
#include "reference/scenes/frequency_brackets.hpp"
#include "reference/scenes/paper_scenes.hpp"
#include "vibro_impact/analysis/analysis.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace vibro_impact::figures {

// --- Section 3: modes and exit boundary ------------------------------------------------------

inline NaturalModes free_modes() {
  return natural_modes(paper::figure2(), Held{0, 0});
}

// The release points (x1, x1') of mass 2 at roots of its hold force.
struct ReleasePoints : Recorder {
  std::vector<double> x = {}, v = {};

  void event(const Event &event, const Moment &moment) override {
    if (event.kind != EventKind::release || event.mass != 2 || event.by_a_jump) return;
    x.push_back(moment.displacement(1));
    v.push_back(moment.velocity(1));
  }
};

struct Line {
  double slope, intercept;
};

// The least-squares line through the release points of several frequencies, so that these points
// spread along the exit boundary.
inline Line exit_boundary_of_mass_2() {
  ReleasePoints points;
  for (double omega : {0.25, 0.26, 0.27, 0.28, 0.29, 0.3, 0.32, 0.34, 0.36, 0.4})
    require_complete(simulate(paper::stops_of_different_sign(omega), 200.0, points));
  const auto n = static_cast<double>(points.x.size());
  double x = 0.0, v = 0.0, xx = 0.0, xv = 0.0;  // means
  for (std::size_t i = 0; i < points.x.size(); ++i) {
    x += points.x[i] / n;
    v += points.v[i] / n;
    xx += points.x[i] * points.x[i] / n;
    xv += points.x[i] * points.v[i] / n;
  }
  const double slope = (xv - x * v) / (xx - x * x);
  return {slope, v - slope * x};
}

// --- Figure 4 --------------------------------------------------------------------------------

// The greatest hold force inside a settled sticking phase. It is negative: mass 1 is pressed into a
// lower stop.
inline double hold_force_peak_of_figure4a() {
  const Scene scene = paper::figure4a();
  const PeriodicOrbit orbit =
      find_periodic_orbit(scene, at_quiet_phase(scene, state_after_periods(scene, 60)));
  if (!orbit.converged) throw std::runtime_error("no orbit of Figure 4(a): " + orbit.why_not);
  return -least_pressing_force(scene, orbit.state, scene.stops[0]).value().value;
}

// --- Figure 5 --------------------------------------------------------------------------------

// Impacts of mass 2 in the sticking phase of mass 1 in the window of Figure 5(a).
inline std::vector<Event> impacts_while_stuck_in_figure5a() {
  std::vector<Event> events = events_of(paper::figure5a(), paper::figure5a_box.to);
  const double stick = first_time(events, EventKind::stick, 1, paper::figure5a_box.from),
               release = first_time(events, EventKind::release, 1, stick);
  std::erase_if(events, [&](const Event &event) {
    return event.kind != EventKind::impact || event.mass != 2 || event.time < stick ||
           event.time > release;
  });
  return events;
}

inline MotionState figure5b_at(double time) {
  return require_complete(simulate(paper::figure5b(), time)).state;
}

// The time about 920 at which mass 2 turns below its stop.
inline double nearest_time_of_figure5b() {
  return zero([](double time) { return figure5b_at(time).velocity[1]; }, 919.6, 920.3);
}

inline double nearest_gap_of_figure5b() {
  const double place = paper::figure5b().stops[1].position;
  return place - figure5b_at(nearest_time_of_figure5b()).displacement[1];
}

inline double release_time_of_figure5c() {
  return first_time(paper::figure5c(), EventKind::release, 1, paper::figure5c_box);
}

inline double impacts_before_the_release_of_figure5c() {
  const double release = release_time_of_figure5c();
  return count(events_of(paper::figure5c(), release, release - 10.0), EventKind::impact, 2);
}

// The mean interval of the bounces of mass 2 from 920 to 985, while mass 1 sticks.
inline double bounce_interval_of_figure5c() {
  const std::vector<Event> events = events_of(paper::figure5c(), 985.0, 920.0);
  const double duration = events.back().time - events.front().time;
  return duration / static_cast<double>(events.size() - 1);
}

// --- Frequencies -----------------------------------------------------------------------------

// The frequency between two at which a count differs.
template <class Count>
double changing_frequency(const Count &count, double one, double other) {
  const CountJump change = bisect(count, std::min(one, other), std::max(one, other));
  return 0.5 * (change.below + change.above);
}

inline double changing_frequency(const paper::StickingChange &change) {
  const auto sticks = [&](double omega) {
    return settled_sticking_phases(paper::figure3(omega), change.mass);
  };
  return changing_frequency(sticks, change.near, change.far);
}

// The motion that settles below the jump, followed upwards to the frequency at which it ends.
inline double end_of_the_motion_below_the_jump() {
  const paper::StickingChange change = paper::border_beyond_the_jump();
  const MotionState settled =
      state_after_periods(paper::figure3(change.near), paper::figure4_settling_periods);
  const auto sticks = [&](double omega) {
    return followed_sticking_phases(omega, change.mass, settled);
  };
  return changing_frequency(sticks, change.near, change.far);
}

// The frequency at which mass 2 of Figure 5(b) grazes its stop. The stop is put back into the
// settled motion without it, because the motion from rest may hit the stop below this frequency.
inline double grazing_frequency() {
  const auto impacts_of_mass_2 = [](double omega) {
    Scene scene = paper::figure5b_without_second_stop(omega);
    const MotionState start = state_after_periods(scene, paper::figure4_settling_periods);
    scene.stops.push_back(paper::figure5b().stops[1]);
    ImpactVelocityRecorder impacts{2, -1.0};
    stroboscopic_map(scene, start, 1, {}, impacts);
    return static_cast<int>(impacts.velocities.size());
  };
  return changing_frequency(impacts_of_mass_2, paper::grazing_below, paper::grazing_above);
}

// --- The table -------------------------------------------------------------------------------

// The functions of all key numbers but the frequencies at which a count of sticking phases changes.
inline const std::map<std::string, double (*)()> &key_number_functions() {
  using namespace paper;
  using enum EventKind;
  static const std::map<std::string, double (*)()> functions{
      {"lambda1", [] { return free_modes().lambda.at(0); }},
      {"lambda2", [] { return free_modes().lambda.at(1); }},
      {"xi1_mass1", [] { return free_modes().shape(0, 0); }},
      {"xi1_mass2", [] { return free_modes().shape(1, 0); }},
      {"xi2_mass1", [] { return free_modes().shape(0, 1); }},
      {"xi2_mass2", [] { return free_modes().shape(1, 1); }},
      {"exit_slope", [] { return exit_boundary_of_mass_2().slope; }},
      {"exit_intercept", [] { return exit_boundary_of_mass_2().intercept; }},
      {"figure2_sticks", [] { return count(events_of(figure2(), 750.0), stick); }},
      {"figure2_releases", [] { return count(events_of(figure2(), 750.0), release); }},
      {"figure2_x2_min", [] { return range_in(figure2(), 2, figure2a_box).lowest; }},
      {"figure2_x1_max", [] { return range_in(figure2(), 1, figure2a_box).highest; }},
      {"figure2b_x2_min", [] { return range_in(figure2(), 2, figure2b_box).lowest; }},
      {"figure2b_chatter_start", [] { return first_time(figure2(), impact, 2, figure2b_box); }},
      {"figure2b_chatter_end",
       [] { return first_time(events_of(figure2(), 750.0), stick, 2, figure2b_box.from); }},
      {"figure3_sticks_of_mass_1_at_0_65", [] { return sticks_of_mass_1(paper::figure3(0.65)); }},
      {"figure4a_sticks_of_mass_1", [] { return sticks_of_mass_1(figure4a()); }},
      {"figure4b_sticks_of_mass_1", [] { return sticks_of_mass_1(figure4b()); }},
      {"figure4a_hold_force_peak", hold_force_peak_of_figure4a},
      {"figure5a_stick_time", [] { return first_time(figure5a(), stick, 1, figure5a_box); }},
      {"figure5a_release_time", [] { return first_time(figure5a(), release, 1, figure5a_box); }},
      {"figure5a_first_impact_while_stuck",
       [] { return impacts_while_stuck_in_figure5a().at(0).time; }},
      {"figure5a_impacts_while_stuck",
       [] { return static_cast<double>(impacts_while_stuck_in_figure5a().size()); }},
      {"figure5b_nearest_time", nearest_time_of_figure5b},
      {"figure5b_nearest_gap", nearest_gap_of_figure5b},
      {"figure5b_x2_min", [] { return range_in(figure5b(), 2, figure5b_box).lowest; }},
      {"figure5b_dual_sticks", [] { return dual_sticks(figure5b(), figure5b_box.to); }},
      {"figure5c_release_time", release_time_of_figure5c},
      {"figure5c_impacts_before_release", impacts_before_the_release_of_figure5c},
      {"figure5c_bounce_interval", bounce_interval_of_figure5c},
      {"figure5c_dual_sticks", [] { return dual_sticks(figure5c_reduced(), figure5c_box.to); }},
      {border_beyond_the_jump().symbol, end_of_the_motion_below_the_jump},
      {"grazing_mass_2_figure5b", grazing_frequency}};
  return functions;
}

// Throws std::runtime_error for a symbol that is computed nowhere.
inline double key_number(const std::string &symbol) {
  for (const paper::StickingChange &change : paper::sticking_changes())
    if (symbol == change.symbol) return changing_frequency(change);
  const auto function = key_number_functions().find(symbol);
  if (function == key_number_functions().end())
    throw std::runtime_error("key number '" + symbol + "': no function computes it");
  return function->second();
}

}  // namespace vibro_impact::figures
