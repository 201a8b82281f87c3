// Planes of the atlas and where the curves of bifurcations in them start.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "grazing.hpp"
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

// The edges of sticking of Figure 3 above 0.59 in frequency, where r = 0.7 has none or too many.
inline std::vector<EdgeStart> high_frequency_starts() {
  return {{"border_mass_1_8", 1, {0.75, 0.25}, {0.75, 0.38}},
          {"border_mass_2_5", 2, {0.75, 0.38}, {0.75, 0.48}},
          {"border_mass_2_6", 2, {0.62, 0.5}, {0.62, 0.6}},
          {"border_mass_1_9", 1, {0.62, 0.58}, {0.62, 0.7}}};
}

// What bounds dual sticking at the frequency of Figure 5(c), towards larger s1. Towards smaller
// ones it is the line s1 = s2, on which the force on mass 2 at rest, k2 (s1 - s2), is zero.
inline std::vector<EdgeStart> dual_sticking_starts() {
  return {{"border_mass_1_5c", 1, {0.26, 0.2}, {0.45, 0.2}}};
}

// A period doubling or a fold on the family of the first impact of a mass in a settled motion of
// period one at (omega, r), `speed` further in speed at most.
struct FamilyStart {
  std::string name;
  Bifurcation what;
  double omega, restitution, speed;
  int mass = 2;
};

inline std::vector<FamilyStart> family_starts() {
  using enum Bifurcation;
  return {{"period_doubling_1", period_doubling, 0.7240, 0.77, 0.003, 1},
          {"fold_1", fold, 0.7240, 0.77, 0.03},
          {"period_doubling_2", period_doubling, 0.6226, 0.77, -0.04}};
}

// The end of the shortest sticking phase of a mass begun after `start`: next to its border orbit.
struct ShortestStick {
  int mass;
  double begun = 0.0, shortest = std::numeric_limits<double>::infinity(), at = 0.0;
  bool open = false;

  void event(const Event &event, const Moment &) {
    if (event.mass != mass || event.kind == EventKind::impact) return;
    if (event.kind == EventKind::stick) begun = event.time;
    if (event.kind == EventKind::release && open && event.time - begun < shortest) {
      shortest = event.time - begun;
      at = begun;
    }
    open = event.kind == EventKind::stick;
  }
};

struct StartedCurve {
  BifurcationCurve curve;
  CurvePoint point;
};

// The curve and its point at the y of the scene, from the motion from rest beside. Throws
// std::runtime_error where there is none.
inline StartedCurve started(const CurveStart &start, const CurvePlane &plane = omega_r_plane()) {
  const bool border = start.what == Bifurcation::border_orbit;
  const double near = start.x + start.side * (border ? 3e-7 : 1e-6);
  const Scene scene = with(plane.scene, plane.x, near);
  const MotionState seed = at_quiet_phase(scene, settled(scene, 600));
  StartedCurve found{{start.what, scene, plane.x, plane.y, static_cast<std::size_t>(start.mass - 1),
                      recurrence(scene, seed).periods},
                     {}};
  if (found.curve.periods == 0) throw std::runtime_error(start.name + ": no periodic orbit beside");
  ShortestStick stick{start.mass};
  stroboscopic_map(scene, seed, found.curve.periods, {}, stick);
  const double time = stick.at - time_of(seed.instant, Clock(scene.omega));
  const auto point =
      point_of(found.curve, {near, get(scene, plane.y)}, {start.side, 0.0}, seed, time);
  if (!point) throw std::runtime_error(start.name + ": no point of the curve found");
  found.point = *point;
  return found;
}

// From the motion from rest just inside the edge, which is located by bisection first.
inline StartedCurve started(const EdgeStart &start, const CurvePlane &plane) {
  const auto at = [&](double part) {
    return PlanePoint{start.sticks.x + part * (start.does_not.x - start.sticks.x),
                      start.sticks.y + part * (start.does_not.y - start.sticks.y)};
  };
  const auto scene_at = [&](double part) {
    return with(with(plane.scene, plane.x, at(part).x), plane.y, at(part).y);
  };
  const auto seed_of = [](const Scene &scene) {
    return at_quiet_phase(scene, settled(scene, 600));
  };
  const auto sticks = [&](double part) {
    const Scene scene = scene_at(part);
    ShortestStick stick{start.mass};
    stroboscopic_map(scene, seed_of(scene), 2, {}, stick);
    return stick.shortest < std::numeric_limits<double>::infinity() ? 1 : 0;
  };
  const double edge = bisect(sticks, 0.0, 1.0, 1e-7).below - 1e-6;
  const Scene scene = scene_at(edge);
  const MotionState seed = seed_of(scene);
  StartedCurve found{{Bifurcation::border_orbit, scene, plane.x, plane.y,
                      static_cast<std::size_t>(start.mass - 1), recurrence(scene, seed).periods},
                     {}};
  if (found.curve.periods == 0) throw std::runtime_error(start.name + ": no periodic orbit beside");
  ShortestStick stick{start.mass};
  stroboscopic_map(scene, seed, found.curve.periods, {}, stick);
  const auto point = point_of(
      found.curve, at(edge), {start.does_not.x - start.sticks.x, start.does_not.y - start.sticks.y},
      seed, stick.at - time_of(seed.instant, Clock(scene.omega)));
  if (!point) throw std::runtime_error(start.name + ": no point of the curve found");
  found.point = *point;
  return found;
}

// The fold or the period doubling on the orbits of a family, in the plane of its parameter and r.
inline std::optional<StartedCurve> started_on(Bifurcation what, const ImpactFamily &family,
                                              const std::vector<ImpactOrbit> &orbits) {
  const BifurcationCurve curve{
      what,        family.scene,  family.parameter, parameter_named("restitution"),
      family.stop, family.periods};
  for (std::size_t k = 1; k < orbits.size(); ++k) {
    const auto found = what == Bifurcation::fold
                           ? fold_between(family, orbits[k - 1], orbits[k])
                           : doubling_between(family, orbits[k - 1], orbits[k]);
    const auto point = found ? point_of(curve, *found) : std::nullopt;
    if (point) return StartedCurve{curve, *point};
  }
  return std::nullopt;
}

inline StartedCurve started(const FamilyStart &start) {
  Scene scene = paper::stops_of_different_sign(start.omega);
  scene.restitution = start.restitution;
  const PeriodicOrbit orbit =
      find_periodic_orbit(scene, at_quiet_phase(scene, settled(scene, 600)), 1);
  const ImpactFamily family{scene, parameter_named("omega"),
                            static_cast<std::size_t>(start.mass - 1), 1};
  const ImpactOrbit first = impact_orbit_of(family, orbit);
  const auto found =
      started_on(start.what, family, follow(family, first, first.speed + start.speed, 0.002));
  if (!found) throw std::runtime_error(start.name + ": not on the family");
  return *found;
}

// Where the motion of Figure 5(b) with an impact of mass 2 every other period ends, towards lower
// frequencies: from a little above.
inline StartedCurve started_end_of_impacts() {
  constexpr double beside = 2e-6;
  MotionState last;
  const double end = end_of_impacting_motion(100, last);
  const Scene scene = figure5b_at(end + beside);
  const PeriodicOrbit orbit =
      find_periodic_orbit(scene, orbit_near(scene, at_quiet_phase(scene, last), 2, {}, 2000), 2);
  const ImpactFamily family{scene, parameter_named("omega"), 1, 2};
  const ImpactOrbit first = impact_orbit_of(family, orbit);
  const auto found = started_on(Bifurcation::fold, family,
                                follow(family, first, 0.3 * first.speed, 0.05 * first.speed));
  if (!found) throw std::runtime_error("end of impacts: not on the family");
  return *found;
}

// Mass 2 of Figure 5(b) grazes: from its scene, in the direction in which mass 2 is farther from
// its stop.
inline StartedCurve started_grazing(const CurvePlane &plane, const PlanePoint &clear) {
  const MotionState seed = at_quiet_phase(plane.scene, settled(plane.scene, 200));
  const BifurcationCurve curve{Bifurcation::grazing, plane.scene, plane.x, plane.y, 1, 1};
  const auto point =
      point_of(curve, {get(plane.scene, plane.x), get(plane.scene, plane.y)}, clear, seed, 0.0);
  if (!point) throw std::runtime_error("grazing: no point of the curve found");
  return {curve, *point};
}

}  // namespace vibro_impact::figures
