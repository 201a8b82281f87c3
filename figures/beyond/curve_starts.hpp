// Planes of the atlas and where the curves of bifurcations in them start.
#pragma once

#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "reference/paper_scenes.hpp"
#include "reference/table_reader.hpp"
#include "vibro_impact/analysis/analysis.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace vibro_impact::figures {

// A plane of the atlas, through a scene.
struct CurvePlane {
  std::string name;
  Scene scene;
  Parameter x, y;
  PlaneBox box;
  double step = 0.03;  // longest along a curve, in units of the box
};

inline std::vector<CurvePlane> curve_planes() {
  const Parameter omega = parameter_named("omega"), r = parameter_named("restitution"),
                  amplitude = parameter_named("amplitude1"), s1 = parameter_named("stop1"),
                  s2 = parameter_named("stop2");
  const PlaneBox stops{0.02, 0.6, 0.02, 0.6};
  return {{"omega_r", paper::figure2(), omega, r, {0.2, 0.8, 0.0, 0.98}, 0.015},
          {"omega_A1", paper::figure2(), omega, amplitude, {0.2, 0.8, 0.02, 1.2}},
          {"5a", paper::figure5a(), s1, s2, stops},
          {"5b", paper::figure5b(), s1, s2, stops},
          {"5c", paper::figure5c(), s1, s2, stops},
          // From r = 1e-4, below which differences in r would reach past 0.
          {"5b_omega_r", paper::figure5b(), omega, r, {0.29, 0.32, 1e-4, 0.98}}};
}

// Throws std::invalid_argument for a name that none has.
inline CurvePlane plane_named(const std::string &name) {
  for (const CurvePlane &plane : curve_planes())
    if (plane.name == name) return plane;
  throw std::invalid_argument("plane " + name + ": there is none");
}

// A bifurcation known to some digits, from which its curve starts.
struct CurveStart {
  std::string plane, name;
  Bifurcation what;
  int mass;
  PlanePoint at, whole;  // to where the phase is whole, the chatter completes, no stop is touched
};

// All, plane by plane. In frequency and restitution the 13 at r = 0.7 come first, under the names
// of bifurcation_points.csv; then edges of sticking elsewhere, or where that has too many. In the
// stops at the frequency of Figure 5(a): where the sticking of mass 2 begins and that of mass 1
// ends; of Figure 5(c): what bounds dual sticking towards larger s1. (Towards smaller ones it is
// the line s1 = s2, on which the force on mass 2 at rest, k2 (s1 - s2), is zero.) All by bisection
// on counts from rest. Mass 2 of Figure 5(b) grazes beside its scene.
inline std::vector<CurveStart> curve_starts() {
  const std::string file = REFERENCE_DIR "/curve_starts.csv";
  std::vector<CurveStart> starts;
  for (const auto &cells : read_rows(file, 8)) {
    using enum Bifurcation;
    const auto number = [&](std::size_t column) { return number_in(file, cells[column]); };
    CurveStart start{cells[0], cells[1], grazing, static_cast<int>(number(3)), {}, {}};
    for (const Bifurcation what : {multi_sliding, border_orbit})
      if (cells[2] == name(what)) start.what = what;
    start.at = {number(4), number(5)};
    start.whole = {number(6), number(7)};
    starts.push_back(start);
  }
  return starts;
}

// Of these the 13 in frequency at r = 0.7.
inline std::vector<CurveStart> starts_in_frequency() {
  std::vector<CurveStart> starts = curve_starts();
  std::erase_if(starts, [](const CurveStart &start) {
    return start.plane != "omega_r" || start.at.y != paper::figure2().restitution;
  });
  return starts;
}

// The one of these with that name. Throws std::invalid_argument for any other.
inline CurveStart start_named(const std::string &name) {
  for (const CurveStart &start : starts_in_frequency())
    if (start.name == name) return start;
  throw std::invalid_argument("start " + name + ": there is none");
}

// When the shortest sticking phase of a mass begins: that next to its border orbit. Nothing where
// no phase begins and ends among the events.
inline std::optional<double> shortest_phase(const std::vector<Event> &events, int mass) {
  std::optional<double> begun, found;
  double shortest = std::numeric_limits<double>::infinity();
  for (const Event &event : events) {
    if (event.mass != mass || event.kind == EventKind::impact) continue;
    if (event.kind == EventKind::release && begun && event.time - *begun < shortest) {
      shortest = event.time - *begun;
      found = begun;
    }
    begun = event.kind == EventKind::stick ? std::optional(event.time) : std::nullopt;
  }
  return found;
}

inline std::vector<Event> events_after(const Scene &scene, const MotionState &start, int periods) {
  EventRecorder told{.from = time_of(start.instant, Clock(scene.omega))};
  stroboscopic_map(scene, start, periods, {}, told);
  return told.events;
}

struct StartedCurve {
  CurveStart start;
  CurvePlane plane;
  BifurcationCurve curve;
  CurvePoint point;
};

// The curve and its point on the line through the start, from the motion that settles from rest
// beside it; of a border orbit the chatter is that before the shortest phase. Throws
// std::runtime_error where there is none.
inline StartedCurve started(const CurveStart &start) {
  const CurvePlane plane = plane_named(start.plane);
  const double near = start.what == Bifurcation::border_orbit ? 3e-7 : 1e-6;
  const PlanePoint beside = moved(start.at, start.whole, near);
  BifurcationCurve curve{start.what, plane.scene, plane.x, plane.y,
                         static_cast<std::size_t>(start.mass - 1)};
  const Scene scene = curve.at(beside);
  const SettledMotion motion = settle(scene, at_quiet_phase(scene, state_after_periods(scene, 1)),
                                      {.run = {}, .longest = 1000});
  if (motion.period == 0) throw std::runtime_error(start.name + ": no periodic orbit beside");
  curve.periods = motion.period;
  const MotionState seed = at_quiet_phase(scene, motion.state);
  const auto begun = shortest_phase(events_after(scene, seed, motion.period), start.mass);
  const double time = begun.value_or(0.0) - time_of(seed.instant, Clock(scene.omega));
  const auto point = point_of(curve, beside, start.whole, seed, time);
  if (!point) throw std::runtime_error(start.name + ": no point of the curve found");
  return {start, plane, curve, *point};
}

}  // namespace vibro_impact::figures
