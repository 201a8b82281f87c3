// The bifurcations of the Figure 2 scene as curves in the plane of forcing frequency and
// restitution: where each starts, and what a count of sticking phases says of its points.
#pragma once

#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "paper_scenes.hpp"
#include "vibro_impact/bifurcation_curve.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace vibro_impact::figures {

// The main plane of the atlas.
constexpr PlaneBox omega_r_box{0.2, 0.8, 0.0, 0.98};

// A bifurcation of one parameter, known to some digits, from which its curve starts.
struct CurveStart {
  std::string name;
  Bifurcation what;
  int mass;
  double omega;  // at r = 0.7
  double side;   // +1, -1: of the frequencies at which the phase is whole, or the chatter completes
};

// As in bifurcation_points.csv; digits enough to start from.
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

// The curve and its point at r = 0.7, from the motion from rest beside. Throws std::runtime_error
// where there is none.
inline StartedCurve started(const CurveStart &start) {
  const bool border = start.what == Bifurcation::border_orbit;
  const double near = start.omega + start.side * (border ? 3e-7 : 1e-6);
  const Scene scene = paper::stops_of_different_sign(near);
  const MotionState seed = at_quiet_phase(scene, settled(scene, 600));
  StartedCurve found{{start.what, scene, parameter_named("omega"), parameter_named("restitution"),
                      static_cast<std::size_t>(start.mass - 1), recurrence(scene, seed).periods},
                     {}};
  if (found.curve.periods == 0) throw std::runtime_error(start.name + ": no periodic orbit beside");
  ShortestStick stick{start.mass};
  stroboscopic_map(scene, seed, found.curve.periods, {}, stick);
  const double time = stick.at - time_of(seed.instant, Clock(scene.omega));
  const auto point =
      point_of(found.curve, {near, scene.restitution}, {start.side, 0.0}, seed, time);
  if (!point) throw std::runtime_error(start.name + ": no point of the curve found");
  found.point = *point;
  return found;
}

// How far from a point of a curve, across it and in units of the box, the count of the sticking
// phases of the orbit changes: by bisection within `reach`, by runs that neither look at the force
// nor resolve the chatter. Nothing where the counts at both ends agree.
inline std::optional<double> distance_by_counting(const BifurcationCurve &curve,
                                                  const CurvePoint &point, const PlaneBox &box,
                                                  double reach = 1e-7) {
  const double width = box.x_to - box.x_from, height = box.y_to - box.y_from;
  const double gx = point.gradient.x * width, gy = point.gradient.y * height,
               length = std::hypot(gx, gy);
  const double omega = curve.at(point.at).omega;
  const auto count = [&](double s) {
    const Scene scene =
        curve.at({point.at.x + s * width * gx / length, point.at.y + s * height * gy / length});
    MotionState seed = point.state;
    seed.instant.phase *= omega / scene.omega;
    const MotionState orbit = orbit_near(scene, seed, curve.periods, {}, 100);
    EventRecorder recorder;
    stroboscopic_map(scene, orbit, curve.periods, {}, recorder);
    int sticks = 0;
    for (const Event &event : recorder.events)
      if (event.kind == EventKind::stick && event.stop == curve.stop) ++sticks;
    return sticks;
  };
  if (count(-reach) == count(reach)) return std::nullopt;
  const Change change = bisect(count, -reach, reach, 1e-12);
  return 0.5 * std::abs(change.below + change.above);
}

// The largest modulus of a Floquet multiplier beside the curve, where the chatter completes.
inline double multiplier_beside(const BifurcationCurve &curve, const CurvePoint &point,
                                const PlaneBox &box) {
  const double width = box.x_to - box.x_from, height = box.y_to - box.y_from;
  const double gx = point.gradient.x * width, gy = point.gradient.y * height,
               away = 1e-6 / std::hypot(gx, gy);
  const Scene scene = curve.at({point.at.x + away * width * gx, point.at.y + away * height * gy});
  MotionState seed = point.state;
  seed.instant.phase *= curve.at(point.at).omega / scene.omega;
  const PeriodicOrbit orbit = find_periodic_orbit(scene, seed, curve.periods);
  if (!orbit.converged || orbit.multipliers.empty())
    return std::numeric_limits<double>::quiet_NaN();
  return orbit.multipliers.front().real();
}

}  // namespace vibro_impact::figures
