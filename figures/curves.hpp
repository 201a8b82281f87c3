// The bifurcations of the paper's scenes as curves in the planes of the atlas: where each starts,
// and what independent runs say of its points.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "paper_scenes.hpp"
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
          {"border_mass_2_3", border_orbit, 2, 0.4038279286, 1.0},
          {"border_mass_1_6", border_orbit, 1, 0.4038337212, 1.0},
          {"border_mass_1_7", border_orbit, 1, 0.4642151872, -1.0},
          {"border_mass_2_4", border_orbit, 2, 0.4747400891, -1.0}};
}

// Of these the ones that are followed in the plane of frequency and amplitude, too.
inline std::vector<CurveStart> amplitude_starts() {
  std::vector<CurveStart> starts;
  for (const CurveStart &start : curve_starts())
    for (const char *name :
         {"multi_sliding_mass_1", "multi_sliding_mass_2", "border_mass_1_7", "border_mass_2_4"})
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

inline StartedCurve started(const FamilyStart &start) {
  Scene scene = paper::stops_of_different_sign(start.omega);
  scene.restitution = start.restitution;
  const PeriodicOrbit orbit =
      find_periodic_orbit(scene, at_quiet_phase(scene, settled(scene, 600)), 1);
  const ImpactFamily family{scene, parameter_named("omega"),
                            static_cast<std::size_t>(start.mass - 1), 1};
  const ImpactOrbit first = impact_orbit_of(family, orbit);
  const std::vector<ImpactOrbit> orbits = follow(family, first, first.speed + start.speed, 0.002);
  const BifurcationCurve curve{start.what,       scene,
                               family.parameter, parameter_named("restitution"),
                               family.stop,      family.periods};
  for (std::size_t k = 1; k < orbits.size(); ++k) {
    const auto found = start.what == Bifurcation::fold
                           ? fold_between(family, orbits[k - 1], orbits[k])
                           : doubling_between(family, orbits[k - 1], orbits[k]);
    const auto point = found ? point_of(curve, *found) : std::nullopt;
    if (point) return {curve, *point};
  }
  throw std::runtime_error(start.name + ": not on the family");
}

// Mass 2 of Figure 5(b) grazes: from the printed stops, in s2.
inline StartedCurve started_grazing(const CurvePlane &plane) {
  const MotionState seed = at_quiet_phase(plane.scene, settled(plane.scene, 200));
  const BifurcationCurve curve{Bifurcation::grazing, plane.scene, plane.x, plane.y, 1, 1};
  const auto point = point_of(curve, {get(plane.scene, plane.x), get(plane.scene, plane.y)},
                              {0.0, 1.0}, seed, 0.0);
  if (!point) throw std::runtime_error("grazing: no point of the curve found");
  return {curve, *point};
}

// The scene beside a point of a curve: across it, in units of the box; and the motion of the point
// there.
struct BesideCurve {
  Scene scene;
  MotionState seed;
};
inline BesideCurve beside(const BifurcationCurve &curve, const CurvePoint &point,
                          const PlaneBox &box, double across) {
  const double width = box.x_to - box.x_from, height = box.y_to - box.y_from;
  const double gx = point.gradient.x * width, gy = point.gradient.y * height,
               s = across / std::hypot(gx, gy);
  BesideCurve found{curve.at({point.at.x + s * width * gx, point.at.y + s * height * gy}),
                    point.state};
  found.seed.instant.phase *= curve.at(point.at).omega / found.scene.omega;
  return found;
}

// How often the mass sticks on the orbit beside, or whether it hits (grazing), by runs that neither
// look at the force nor resolve the chatter; of a period doubling, how many Floquet multipliers of
// the stroboscopic map lie outside the unit circle.
inline int count_beside(const BifurcationCurve &curve, const BesideCurve &at) {
  const auto &[scene, seed] = at;
  if (curve.what == Bifurcation::period_doubling) {
    const PeriodicOrbit orbit =
        find_periodic_orbit(scene, at_quiet_phase(scene, seed), curve.periods);
    if (!orbit.converged) return -1;
    return static_cast<int>(
        std::count_if(orbit.multipliers.begin(), orbit.multipliers.end(),
                      [](const auto &multiplier) { return std::abs(multiplier) > 1.0; }));
  }
  const EventKind kind = curve.what == Bifurcation::grazing ? EventKind::impact : EventKind::stick;
  EventRecorder recorder;
  // Beyond a grazing impacts may come now and then only.
  const int periods = kind == EventKind::impact ? 60 : curve.periods;
  stroboscopic_map(scene, orbit_near(scene, seed, curve.periods, {}, 100), periods, {}, recorder);
  return static_cast<int>(std::count_if(
      recorder.events.begin(), recorder.events.end(),
      [&](const Event &event) { return event.kind == kind && event.stop == curve.stop; }));
}

// How far from a point of a curve, across it and in units of the box, this count changes: by
// bisection within 1e-9, or where the counts at both ends agree, 1e-7. (Other curves may be as
// near: two chatters that hardly fail to complete lie between each other's.) Nothing where they
// agree there, too, and for a fold, on one side of which there is no orbit to count on.
inline std::optional<double> distance_by_counting(const BifurcationCurve &curve,
                                                  const CurvePoint &point, const PlaneBox &box) {
  if (curve.what == Bifurcation::fold) return std::nullopt;
  const auto count = [&](double s) { return count_beside(curve, beside(curve, point, box, s)); };
  for (const double reach : {1e-9, 1e-7}) {
    if (count(-reach) == count(reach)) continue;
    const Change change = bisect(count, -reach, reach, 1e-12);
    return 0.5 * std::abs(change.below + change.above);
  }
  return std::nullopt;
}

// A Floquet multiplier of the stroboscopic map: the largest by modulus beside the curve, where the
// phase is whole or the chatter completes; on a period doubling or a fold the one nearest to -1
// or 1.
inline double multiplier_at(const BifurcationCurve &curve, const CurvePoint &point,
                            const PlaneBox &box) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const bool doubling = curve.what == Bifurcation::period_doubling;
  if (doubling || curve.what == Bifurcation::fold) {
    const Scene scene = curve.at(point.at);
    const MotionState at = at_quiet_phase(scene, point.state);
    const Matrix map = stroboscopic_map_and_derivative(scene, at, curve.periods).derivative;
    const double due = doubling ? -1.0 : 1.0;
    double nearest = nan;
    for (const auto &multiplier : floquet_multipliers(map, at.held))
      if (!(std::abs(nearest - due) <= std::abs(multiplier - due))) nearest = multiplier.real();
    return nearest;
  }
  const auto [scene, seed] = beside(curve, point, box, 1e-6);
  const PeriodicOrbit orbit = find_periodic_orbit(scene, seed, curve.periods);
  return orbit.converged && !orbit.multipliers.empty() ? orbit.multipliers.front().real() : nan;
}

}  // namespace vibro_impact::figures
