// Planes of the atlas and where the curves of bifurcations in them start.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "reference/scenes/paper_scenes.hpp"
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

  PlanePoint of_scene() const {
    return {get(scene, x), get(scene, y)};
  }
  Scene at(const PlanePoint &point) const {
    return with(with(scene, x, point.x), y, point.y);
  }
};

inline CurvePlane omega_r_plane() {
  return {"omega_r",
          paper::figure2(),
          parameter_named("omega"),
          parameter_named("restitution"),
          {0.2, 0.8, 0.0, 0.98},
          0.015};
}
inline CurvePlane omega_A1_plane() {
  return {"omega_A1",
          paper::figure2(),
          parameter_named("omega"),
          parameter_named("amplitude1"),
          {0.2, 0.8, 0.02, 1.2}};
}
// Frequency and restitution at the stops of Figure 5(b); from r = 1e-4, below which differences in
// r would reach past 0.
inline CurvePlane omega_r_plane_5b() {
  return {"5b_omega_r",
          paper::figure5b(),
          parameter_named("omega"),
          parameter_named("restitution"),
          {0.29, 0.32, 1e-4, 0.98}};
}
inline CurvePlane stops_plane(const std::string &name, const Scene &scene) {
  return {name, scene, parameter_named("stop1"), parameter_named("stop2"), {0.02, 0.6, 0.02, 0.6}};
}

// A bifurcation of one parameter, known to some digits, from which its curve starts.
struct CurveStart {
  std::string name;
  Bifurcation what;
  int mass;
  double x;     // at the y of the plane's scene
  double side;  // +1, -1: of the x at which the phase is whole, or the chatter completes
};

// In frequency, at r = 0.7 and A1 = 0.5; as in bifurcation_points.csv, digits enough to start from.
inline std::vector<CurveStart> curve_starts() {
  using enum Bifurcation;
  return {{"multi_sliding_mass_1", multi_sliding, 1, 0.2560063298, -1.0},
          {"border_mass_1_1", border_orbit, 1, 0.2574556780, -1.0},
          {"multi_sliding_mass_2", multi_sliding, 2, 0.2680958464, -1.0},
          {"border_mass_2_1", border_orbit, 2, 0.2684679874, -1.0},
          {"border_mass_1_2", border_orbit, 1, 0.2965442860, -1.0},
          {"border_mass_1_3", border_orbit, 1, 0.3309823529, 1.0},
          {"border_mass_2_2", border_orbit, 2, 0.3670049140, -1.0},
          {"border_mass_1_4", border_orbit, 1, 0.3678202574, -1.0},
          {"border_mass_1_5", border_orbit, 1, 0.3678229909, -1.0},
          {"border_mass_2_3", border_orbit, 2, 0.4038279286, 1.0},
          {"border_mass_1_6", border_orbit, 1, 0.4038337212, 1.0},
          {"border_mass_1_7", border_orbit, 1, 0.4642151872, -1.0},
          {"border_mass_2_4", border_orbit, 2, 0.4747400891, -1.0}};
}

// Of these the ones that are followed in the plane of frequency and amplitude, too.
inline std::vector<CurveStart> amplitude_starts() {
  std::vector<CurveStart> starts;
  for (const CurveStart &start : curve_starts())
    for (const char *name : {"multi_sliding_mass_1", "multi_sliding_mass_2", "border_mass_1_2",
                             "border_mass_2_2", "border_mass_1_7", "border_mass_2_4"})
      if (start.name == name) starts.push_back(start);
  return starts;
}

// In s1 at the frequency of Figure 5(a) and s2 = 0.3: where the sticking of mass 2 begins and that
// of mass 1 ends, by bisection on counts from rest.
inline std::vector<CurveStart> stops_starts() {
  using enum Bifurcation;
  return {{"border_mass_2_5a", border_orbit, 2, 0.3188603608, 1.0},
          {"border_mass_1_5a", border_orbit, 1, 0.3625266385, -1.0}};
}

// An edge of the sticking of a mass, in any plane: it sticks in the motion from rest at one place,
// and does not at the other.
struct EdgeStart {
  std::string name;
  int mass;
  PlanePoint sticks, does_not;
};

// Edges of sticking in frequency and restitution away from r = 0.7, or where that has too many.
inline std::vector<EdgeStart> omega_r_edges() {
  return {{"border_mass_1_8", 1, {0.75, 0.25}, {0.75, 0.38}},
          {"border_mass_2_5", 2, {0.75, 0.38}, {0.75, 0.48}},
          {"border_mass_2_6", 2, {0.62, 0.5}, {0.62, 0.6}},
          {"border_mass_1_9", 1, {0.62, 0.58}, {0.62, 0.7}},
          {"border_mass_2_7", 2, {0.24, 0.7}, {0.24, 0.85}},
          {"border_mass_2_8", 2, {0.3, 0.69}, {0.3, 0.76}},
          {"border_mass_2_9", 2, {0.43, 0.7}, {0.43, 0.76}},
          {"border_mass_1_10", 1, {0.515, 0.52}, {0.515, 0.58}},
          {"border_mass_2_10", 2, {0.515, 0.52}, {0.515, 0.58}},
          {"border_mass_2_11", 2, {0.72, 0.44}, {0.72, 0.52}}};
}

// What bounds dual sticking at the frequency of Figure 5(c), towards larger s1. Towards smaller
// ones it is the line s1 = s2, on which the force on mass 2 at rest, k2 (s1 - s2), is zero.
inline std::vector<EdgeStart> dual_sticking_starts() {
  return {{"border_mass_1_5c", 1, {0.26, 0.2}, {0.45, 0.2}}};
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
  std::string name;
  BifurcationCurve curve;
  CurvePoint point;
};

// A curve and its point on the line through `beside` in direction `across`, from the motion that
// settles from rest there: the phase is whole, the chatter completes, the stop is not touched; of a
// border orbit the chatter is that before the shortest phase. Throws std::runtime_error where there
// is none.
inline StartedCurve started(const std::string &name, const CurvePlane &plane, Bifurcation what,
                            int mass, const PlanePoint &beside, const PlanePoint &across) {
  const Scene scene = plane.at(beside);
  const SettledMotion motion =
      settle(scene, at_quiet_phase(scene, settled(scene, 1)), {.run = {}, .longest = 1000});
  if (motion.period == 0) throw std::runtime_error(name + ": no periodic orbit beside");
  const MotionState seed = at_quiet_phase(scene, motion.state);
  StartedCurve found{
      name, {what, scene, plane.x, plane.y, static_cast<std::size_t>(mass - 1), motion.period}, {}};
  const auto begun = shortest_phase(events_after(scene, seed, motion.period), mass);
  const double time = begun.value_or(0.0) - time_of(seed.instant, Clock(scene.omega));
  const auto point = point_of(found.curve, beside, across, seed, time);
  if (!point) throw std::runtime_error(name + ": no point of the curve found");
  found.point = *point;
  return found;
}

inline StartedCurve started(const CurveStart &start, const CurvePlane &plane = omega_r_plane()) {
  const double near = start.what == Bifurcation::border_orbit ? 3e-7 : 1e-6;
  return started(start.name, plane, start.what, start.mass,
                 {start.x + start.side * near, plane.of_scene().y}, {start.side, 0.0});
}

// From just inside the edge, which is located by bisection first.
inline StartedCurve started(const EdgeStart &start, const CurvePlane &plane) {
  const PlanePoint way{start.does_not.x - start.sticks.x, start.does_not.y - start.sticks.y};
  const auto sticks = [&](double part) {
    const Scene scene = plane.at(moved(start.sticks, way, part));
    const MotionState at = at_quiet_phase(scene, settled(scene, 600));
    return shortest_phase(events_after(scene, at, 2), start.mass) ? 1 : 0;
  };
  const double edge = bisect(sticks, 0.0, 1.0, 1e-7).below - 1e-6;
  return started(start.name, plane, Bifurcation::border_orbit, start.mass,
                 moved(start.sticks, way, edge), {-way.x, -way.y});
}

// Mass 2 of Figure 5(b) grazes: from its scene, in the direction in which mass 2 is farther from
// its stop.
inline StartedCurve started_grazing(const CurvePlane &plane, const PlanePoint &clear) {
  return started("grazing_mass_2", plane, Bifurcation::grazing, 2, plane.of_scene(), clear);
}

}  // namespace vibro_impact::figures
