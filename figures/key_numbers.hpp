// The paper's key numbers, computed by the library. Each row names the reference it is held against
// (a symbol of reference/key_numbers.csv), the tolerance and why that one.
#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "figures/beyond/table1_scenes.hpp"
#include "figures/printed.hpp"
#include "reference/scenes/paper_scenes.hpp"
#include "vibro_impact/analysis/analysis.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace vibro_impact::figures {

struct KeyNumber {
  std::string symbol;  // in reference/key_numbers.csv
  std::string meaning;
  Printed printed;       // what the paper says, and what that can tell
  std::string decimals;  // how many digits to show, as a format
  double tolerance;      // absolute
  std::string why;       // why that tolerance
  std::function<double()> compute;
};

// The release points (x1, x1') of mass 2 at roots of its hold force, over several frequencies so
// that they spread along the exit boundary; a least-squares line through them.
struct Line {
  double slope, intercept;
};

struct ReleasePoints {
  int mass = 2;
  std::vector<double> x = {}, v = {};

  void event(const Event &event, const Moment &moment) {
    if (event.kind != EventKind::release || event.mass != mass || event.by_a_jump) return;
    x.push_back(moment.displacement(1));
    v.push_back(moment.velocity(1));
  }
};

inline Line exit_boundary_of_mass_2() {
  ReleasePoints points;
  for (double omega : {0.25, 0.26, 0.27, 0.28, 0.29, 0.3, 0.32, 0.34, 0.36, 0.4})
    require_complete(simulate(paper::stops_of_different_sign(omega), 200.0, {}, points));
  double mean_x = 0.0, mean_v = 0.0, xx = 0.0, xv = 0.0;
  const auto n = static_cast<double>(points.x.size());
  for (std::size_t i = 0; i < points.x.size(); ++i) {
    mean_x += points.x[i] / n;
    mean_v += points.v[i] / n;
  }
  for (std::size_t i = 0; i < points.x.size(); ++i) {
    xx += (points.x[i] - mean_x) * (points.x[i] - mean_x);
    xv += (points.x[i] - mean_x) * (points.v[i] - mean_v);
  }
  const double slope = xv / xx;
  return {slope, mean_v - slope * mean_x};
}

// Events of a paper scene up to `until`.
inline std::vector<Event> events_of(const Scene &scene, double until, double from = 0.0) {
  EventRecorder recorder;
  recorder.from = from;
  require_complete(simulate(scene, until, {}, recorder));
  return recorder.events;
}

inline double count(const std::vector<Event> &events, EventKind kind, int mass = 0) {
  double n = 0.0;
  for (const Event &event : events)
    if (event.kind == kind && (mass == 0 || event.mass == mass)) n += 1.0;
  return n;
}

// How often a mass comes to rest while the other one is held.
inline double dual_sticks(const Scene &scene, double until) {
  double n = 0.0;
  for (const Event &event : events_of(scene, until))
    if (event.kind == EventKind::stick && contact_mode_name(event.held) == "1+2") n += 1.0;
  return n;
}

// Time of the first event of this kind and mass at or after `from`.
inline double first_time(const std::vector<Event> &events, EventKind kind, int mass, double from) {
  for (const Event &event : events)
    if (event.kind == kind && event.mass == mass && event.time >= from) return event.time;
  return std::nan("");
}

// Greatest displacement of a mass among samples every `every` in [from, to].
inline double extreme(const Scene &scene, int mass, double sense, double from, double to,
                      double every) {
  SampleRecorder samples;
  samples.from = from;
  samples.to = to;
  samples.every = every;
  require_complete(simulate(scene, to, {}, samples));
  double most = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < samples.times.size(); ++i)
    most =
        std::max(most, sense * samples.displacements[2 * i + static_cast<std::size_t>(mass - 1)]);
  return sense * most;
}

// The greatest hold force on mass 1 in the last ten periods to `until` (negative: it is pressed).
inline double hold_force_peak(const Scene &scene, double until) {
  const double period = 2.0 * std::acos(-1.0) / scene.omega;
  HoldForceRecorder hold;
  hold.from = until - 10.0 * period;
  hold.to = until;
  hold.every = 1e-4;
  require_complete(simulate(scene, until, {}, hold));
  // The ends of a phase are at zero by definition: only points well inside count.
  double peak = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 200; i + 200 < hold.rows.size(); ++i)
    if (hold.rows[i - 200].phase == hold.rows[i + 200].phase &&
        hold.rows[i].force > hold.rows[i - 200].force &&
        hold.rows[i].force > hold.rows[i + 200].force)
      peak = std::max(peak, hold.rows[i].force);
  return peak;
}

inline std::vector<KeyNumber> key_numbers() {
  using paper::figure2, paper::figure4a, paper::figure4b, paper::figure5a, paper::figure5c;
  // The eigenvalue of a mode (mass 0), or its shape at mass 1 or 2; modes are counted from 1.
  const auto modes = [](std::size_t mass, std::size_t mode) {
    return [mass, mode] {
      const NaturalModes free = natural_modes(figure2(), Held{0, 0});
      return mass == 0 ? free.lambda.at(mode - 1) : free.shape(mass - 1, mode - 1);
    };
  };
  const auto sticks_of_mass_1 = [](const Scene &scene) {
    const double period = 2.0 * std::acos(-1.0) / scene.omega;
    return count(events_of(scene, 750.0, 750.0 - 10.0 * period), EventKind::stick, 1);
  };
  const std::string rounding = "rounding of the eigensolver";
  const std::string event_time = "event times are asserted to 1e-10 up to t = 750";
  const std::string exact = "a count";
  return {
      {"lambda1", "eigenvalue of E, N = 2", digits("0.382"), "{:.15f}", 1e-14, rounding,
       modes(0, 1)},
      {"lambda2", "eigenvalue of E, N = 2", digits("2.618"), "{:.15f}", 1e-14, rounding,
       modes(0, 2)},
      {"xi1_mass1", "first eigenvector, mass 1", digits("0.526"), "{:.15f}", 1e-14, rounding,
       modes(1, 1)},
      {"xi1_mass2", "first eigenvector, mass 2", digits("0.851"), "{:.15f}", 1e-14, rounding,
       modes(2, 1)},
      {"xi2_mass1", "second eigenvector, mass 1", digits("-0.851"), "{:.15f}", 1e-14, rounding,
       modes(1, 2)},
      {"xi2_mass2", "second eigenvector, mass 2", digits("0.526"), "{:.15f}", 1e-14, rounding,
       modes(2, 2)},
      {"exit_slope", "exit boundary of mass 2, slope (fitted to simulated releases)", digits("-10"),
       "{:.12f}", 1e-9, "rounding of a release point times c/k over the spread of the points",
       [] { return exit_boundary_of_mass_2().slope; }},
      {"exit_intercept", "exit boundary of mass 2, intercept", digits("1"), "{:.12f}", 1e-9,
       "as the slope", [] { return exit_boundary_of_mass_2().intercept; }},
      {"figure2_sticks",
       "Figure 2: sticks to t = 750",
       {},
       "{:.0f}",
       0.0,
       exact,
       [] { return count(events_of(figure2(), 750.0), EventKind::stick); }},
      {"figure2_releases",
       "Figure 2: releases to t = 750",
       {},
       "{:.0f}",
       0.0,
       exact,
       [] { return count(events_of(figure2(), 750.0), EventKind::release); }},
      {"figure2_x2_min", "Figure 2(a): lowest x2 (by which Omega is inferred)",
       between("-0.5", "-0.4"), "{:.9f}", 1e-8, "samples every 1e-4: (1e-4)^2 x'' / 8",
       [] { return extreme(figure2(), 2, -1.0, 700.0, 750.0, 1e-4); }},
      {"figure2_x1_max", "Figure 2(a): highest x1 (by which Omega is inferred)",
       between("0.3", "0.4"), "{:.9f}", 1e-8, "samples every 1e-4: (1e-4)^2 x'' / 8",
       [] { return extreme(figure2(), 1, 1.0, 700.0, 750.0, 1e-4); }},
      {"figure2b_x2_min", "Figure 2(b): lowest x2 (by which Omega is inferred)",
       between("-0.06", "-0.04"), "{:.9f}", 1e-8, "samples every 1e-4: (1e-4)^2 x'' / 8",
       [] { return extreme(figure2(), 2, -1.0, 715.0, 722.0, 1e-4); }},
      {"figure2b_chatter_start",
       "Figure 2(b): mass 2's first impact",
       {},
       "{:.11f}",
       1e-10,
       event_time,
       [] { return first_time(events_of(figure2(), 750.0), EventKind::impact, 2, 715.0); }},
      {"figure2b_chatter_end",
       "Figure 2(b): mass 2's chatter is complete",
       {},
       "{:.11f}",
       1e-10,
       event_time,
       [] { return first_time(events_of(figure2(), 750.0), EventKind::stick, 2, 715.0); }},
      {"figure4a_sticks_of_mass_1", "sticks of mass 1 in ten periods, Omega = 0.256",
       exactly("one a period", 10.0), "{:.0f}", 0.0, exact,
       [sticks_of_mass_1] { return sticks_of_mass_1(figure4a()); }},
      {"figure4b_sticks_of_mass_1", "sticks of mass 1 in ten periods, Omega = 0.2561",
       exactly("two a period", 20.0), "{:.0f}", 0.0, exact,
       [sticks_of_mass_1] { return sticks_of_mass_1(figure4b()); }},
      {"figure3_sticks_of_mass_1_at_0_65",
       "Figure 3: sticks of mass 1 in ten periods, Omega = 0.65", exactly("none above 0.5", 0.0),
       "{:.0f}", 0.0, exact, [sticks_of_mass_1] { return sticks_of_mass_1(paper::figure3(0.65)); }},
      {"figure4a_hold_force_peak", "Figure 4(a): the force just short of zero",
       between("-0.02", "0"), "{:.9e}", 1e-9, "samples every 1e-4: (1e-4)^2 F'' / 8",
       [] { return hold_force_peak(figure4a(), 750.0); }},
      {"figure5a_stick_time",
       "Figure 5(a): mass 1 sticks",
       {},
       "{:.11f}",
       1e-10,
       event_time,
       [] { return first_time(events_of(figure5a(), 964.0), EventKind::stick, 1, 950.0); }},
      {"figure5a_impacts_while_stuck",
       "Figure 5(a): impacts of mass 2 in the sticking phase (by which Omega is inferred)",
       exactly("two", 2.0), "{:.0f}", 0.0, exact,
       [] {
         const auto events = events_of(figure5a(), 964.0);
         const double from = first_time(events, EventKind::stick, 1, 950.0);
         return count(events_of(figure5a(), 964.0, from), EventKind::impact, 2);
       }},
      {"figure5b_nearest_time",
       "Figure 5(b): time at which mass 2 is nearest s2 (by which Omega is inferred)",
       digits("920"), "{:.11f}", 1e-10, event_time,
       [] { return turning_time(paper::figure5b(), 2, 919.6, 920.3); }},
      {"figure5b_nearest_gap", "Figure 5(b): gap of mass 2 then (by which Omega is inferred)",
       exactly("it grazes", 0.0), "{:.9e}", 1e-12, "rounding of x: the gap turns there",
       [] {
         const Scene scene = paper::figure5b();
         const double time = turning_time(scene, 2, 919.6, 920.3);
         return scene.stops[1].position - place_at(scene, 2, time);
       }},
      {"figure5b_x2_min", "Figure 5(b): lowest x2 (by which Omega is inferred)",
       between("-0.4", "-0.3"), "{:.9f}", 1e-8, "samples every 1e-4: (1e-4)^2 x'' / 8",
       [] { return extreme(paper::figure5b(), 2, -1.0, 916.0, 930.0, 1e-4); }},
      {"figure5b_dual_sticks", "Figure 5(b): times at which both masses stick, to t = 930",
       at_least_once("dual sticking"), "{:.0f}", 0.0, exact,
       [] { return dual_sticks(paper::figure5b(), paper::figure5b_box.to); }},
      {"figure5c_release_time",
       "Figure 5(c): mass 1 is released",
       {},
       "{:.11f}",
       1e-10,
       event_time,
       [] { return first_time(events_of(figure5c(), 1000.0), EventKind::release, 1, 900.0); }},
      {"figure5c_bounce_interval",
       "Figure 5(c): bounce interval of mass 2",
       {},
       "{:.12f}",
       1e-12,
       "t near 1000: a few units in the last place, averaged over 20 bounces",
       [] {
         const auto events = events_of(figure5c(), 985.0, 920.0);
         const Event &first = events.front(), &last = events.back();
         return (last.time - first.time) / static_cast<double>(events.size() - 1);
       }},
      {"figure5c_dual_sticks", "Figure 5(c) at lower Omega and r: times at which both masses stick",
       at_least_once("leads to dual sticking"), "{:.0f}", 0.0, exact,
       [] { return dual_sticks(paper::figure5c_reduced(), paper::figure5c_box.to); }},
  };
}

}  // namespace vibro_impact::figures
