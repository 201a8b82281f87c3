// The paper's key numbers, and the located ones that the paper reads off its diagrams or does not
// have, as the library computes them, by their symbols in the tables of reference/.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "figures/beyond/curve_starts.hpp"
#include "figures/grazing.hpp"
#include "figures/table1_scenes.hpp"
#include "figures/panel.hpp"
#include "reference/paper_scenes.hpp"
#include "vibro_impact/analysis/analysis.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace vibro_impact::figures {

// The release points (x1, x1') of mass 2 at roots of its hold force, over several frequencies so
// that they spread along the exit boundary; a least-squares line through them.
struct Line {
  double slope, intercept;
};

struct ReleasePoints {
  std::vector<double> x = {}, v = {};

  void event(const Event &event, const Moment &moment) {
    if (event.kind != EventKind::release || event.mass != 2 || event.by_a_jump) return;
    x.push_back(moment.displacement(1));
    v.push_back(moment.velocity(1));
  }
};

inline Line exit_boundary_of_mass_2() {
  ReleasePoints points;
  for (double omega : {0.25, 0.26, 0.27, 0.28, 0.29, 0.3, 0.32, 0.34, 0.36, 0.4})
    require_complete(simulate(paper::stops_of_different_sign(omega), 200.0, {}, points));
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

// Events of a paper scene up to `until`.
inline std::vector<Event> events_of(const Scene &scene, double until, double from = 0.0) {
  EventRecorder recorder;
  recorder.from = from;
  require_complete(simulate(scene, until, {}, recorder));
  return recorder.events;
}

// How many there are of a kind, of this mass (0: any), in this contact mode ("": any).
inline double count(const std::vector<Event> &events, EventKind kind, int mass = 0,
                    const std::string &mode = "") {
  return static_cast<double>(std::count_if(events.begin(), events.end(), [&](const Event &event) {
    return event.kind == kind && (mass == 0 || event.mass == mass) &&
           (mode.empty() || contact_mode_name(event.held) == mode);
  }));
}

// Time of the first event of this kind and mass at or after `from`.
inline double first_time(const std::vector<Event> &events, EventKind kind, int mass, double from) {
  for (const Event &event : events)
    if (event.kind == kind && event.mass == mass && event.time >= from) return event.time;
  return std::nan("");
}

// The displacements of a mass in the window of a panel, among samples every 1e-4.
inline Range range_in(const Scene &scene, int mass, const paper::AxisBox &box) {
  SampleRecorder samples = samples_across(box, 1e-4);
  require_complete(simulate(scene, samples.to, {}, samples));
  return range_of(samples, mass);
}

inline std::map<std::string, std::function<double()>> key_numbers() {
  using namespace paper;
  // The eigenvalue of a mode (mass 0), or its shape at mass 1 or 2; modes are counted from 1.
  const auto modes = [](std::size_t mass, std::size_t mode) {
    return [mass, mode] {
      const NaturalModes free = natural_modes(figure2(), Held{0, 0});
      return mass == 0 ? free.lambda.at(mode - 1) : free.shape(mass - 1, mode - 1);
    };
  };
  const auto sticks_of_mass_1 = [](const Scene &scene) {
    return [scene] {
      const double from = 750.0 - 10.0 * Clock(scene.omega).period;
      return count(events_of(scene, 750.0, from), EventKind::stick, 1);
    };
  };
  const auto number_of = [](EventKind kind) {
    return [kind] { return count(events_of(figure2(), 750.0), kind); };
  };
  const auto first = [](const Scene &scene, EventKind kind, int mass, const AxisBox &box) {
    return [=] { return first_time(events_of(scene, box.to), kind, mass, box.from); };
  };
  const auto lowest = [](const Scene &scene, int mass, const AxisBox &box) {
    return [=] { return range_in(scene, mass, box).lowest; };
  };
  // How often a mass comes to rest while the other one is held.
  const auto dual_sticks = [](const Scene &scene, const AxisBox &box) {
    return [=] { return count(events_of(scene, box.to), EventKind::stick, 0, "1+2"); };
  };
  // The position of the stop of a mass in a scene of Table I.
  const auto stop = [](auto scene_of, std::size_t mass) {
    return [=] { return scene_of().scene.stops[mass - 1].position; };
  };
  std::map<std::string, std::function<double()>> functions{
      {"lambda1", modes(0, 1)},
      {"lambda2", modes(0, 2)},
      {"xi1_mass1", modes(1, 1)},
      {"xi1_mass2", modes(2, 1)},
      {"xi2_mass1", modes(1, 2)},
      {"xi2_mass2", modes(2, 2)},
      {"exit_slope", [] { return exit_boundary_of_mass_2().slope; }},
      {"exit_intercept", [] { return exit_boundary_of_mass_2().intercept; }},
      {"figure2_sticks", number_of(EventKind::stick)},
      {"figure2_releases", number_of(EventKind::release)},
      {"figure2_x2_min", lowest(figure2(), 2, figure2a_box)},
      {"figure2_x1_max", [] { return range_in(figure2(), 1, figure2a_box).highest; }},
      {"figure2b_x2_min", lowest(figure2(), 2, figure2b_box)},
      {"figure2b_chatter_start", first(figure2(), EventKind::impact, 2, figure2b_box)},
      {"figure2b_chatter_end", first(figure2(), EventKind::stick, 2, figure2b_box)},
      {"figure4a_sticks_of_mass_1", sticks_of_mass_1(figure4a())},
      {"figure4b_sticks_of_mass_1", sticks_of_mass_1(figure4b())},
      {"figure3_sticks_of_mass_1_at_0_65", sticks_of_mass_1(paper::figure3(0.65))},
      {"figure4a_hold_force_peak",
       [] {  // negative: mass 1 is pressed into a lower stop
         const Scene scene = figure4a();
         const MotionState orbit =
             orbit_near(scene, at_quiet_phase(scene, state_after_periods(scene, 60)), 1).value();
         return -least_pressing_force(scene, orbit, scene.stops[0]).value().value;
       }},
      {"figure5a_stick_time", first(figure5a(), EventKind::stick, 1, figure5a_box)},
      {"figure5a_impacts_while_stuck",
       [] {
         const auto events = events_of(figure5a(), 964.0);
         const double from = first_time(events, EventKind::stick, 1, 950.0);
         return count(events_of(figure5a(), 964.0, from), EventKind::impact, 2);
       }},
      {"figure5b_nearest_time", [] { return turning_time(figure5b(), 2, 919.6, 920.3); }},
      {"figure5b_nearest_gap",
       [] {
         const double time = turning_time(figure5b(), 2, 919.6, 920.3);
         return figure5b().stops[1].position - place_at(figure5b(), 2, time);
       }},
      {"figure5b_x2_min", lowest(figure5b(), 2, figure5b_box)},
      {"figure5b_dual_sticks", dual_sticks(figure5b(), figure5b_box)},
      {"figure5c_release_time", first(figure5c(), EventKind::release, 1, figure5c_box)},
      {"figure5c_bounce_interval",
       [] {
         const auto events = events_of(figure5c(), 985.0, 920.0);
         const Event &one = events.front(), &last = events.back();
         return (last.time - one.time) / static_cast<double>(events.size() - 1);
       }},
      {"figure5c_dual_sticks", dual_sticks(figure5c_reduced(), figure5c_box)},
      {"grazing_mass_2_figure5b", [] { return grazing().omega.value; }},
      {"DG_Omega", [] { return dual_grazing().scene.omega; }},
      {"DG_s1", stop(dual_grazing, 1)},
      {"DG_s2", stop(dual_grazing, 2)},
      {"DI_s2", stop(double_impact, 2)},
      {"GS_s2", stop(grazing_sticking, 2)},
      {"GI_s1", stop(grazing_impact, 1)},
      {"GI_s2", stop(grazing_impact, 2)},
      {"DS_from", [] { return dual_sticking().time; }},
  };
  for (const CurveStart &start : starts_in_frequency())
    functions[start.name] = [start] { return started(start).point.at.x; };
  return functions;
}

}  // namespace vibro_impact::figures
