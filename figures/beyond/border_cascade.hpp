// The border orbits unfolded: beyond the border the chatter has finitely many impacts, one more
// each time the distance to the border shrinks by the same factor. The orbit followed there, and
// where each impact is added: by a grazing of the last flight before the mass is let go.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bifurcations.hpp"
#include "curves.hpp"
#include "vibro_impact/analysis/orbit_change.hpp"

namespace vibro_impact::figures {

// The impacts of one mass, one sequence (FallingSequence) after the other, each with the motion
// right after its last impact.
struct LastImpacts {
  struct Sequence {
    double begin = 0.0;
    int impacts = 0;
    bool complete = false;
    MotionState last = {};
  };
  int mass;
  std::vector<Sequence> sequences = {};
  bool open = false;

  void event(const Event &event, const Moment &moment) {
    if (event.mass != mass) return;
    if (event.kind != EventKind::impact) {
      if (event.kind == EventKind::stick && open) sequences.back().complete = true;
      open = false;
      return;
    }
    if (!open || event.falling == 0) sequences.push_back({event.time});
    open = true;
    Sequence &sequence = sequences.back();
    ++sequence.impacts;
    sequence.last = {event.instant, {}, {}, event.held};
    for (int i = 1; i <= moment.masses(); ++i) {
      sequence.last.displacement.push_back(moment.displacement(i));
      sequence.last.velocity.push_back(i == mass ? event.velocity_after : moment.velocity(i));
    }
  }
};

// How far the flight after an impact stays clear of the stop: the gap over the time since the
// impact, where that is least (its minimum nearest to the impact), in units of the speed after the
// impact. Zero where the flight grazes, positive where it clears. Nothing where there is no such
// minimum. The gap is a Taylor series about the impact, where it is zero: nothing cancels, however
// slow the impact is. The derivatives of the motion obey its equation with those of the forcing, in
// phase a quarter of a period ahead each.
inline std::optional<double> clearance_after(Scene scene, std::size_t stop, MotionState motion) {
  constexpr int order = 24;
  const double sigma = sign(scene.stops[stop].side), quarter = Clock(scene.omega).period / 4;
  const auto mass = static_cast<std::size_t>(scene.stops[stop].mass - 1);
  const double speed = -sigma * motion.velocity[mass];
  std::vector<double> c{1.0};  // gap / (speed t) = c_0 + c_1 t + ...
  double factorial = 1.0;
  for (int k = 2; k <= order; ++k) {
    factorial *= k;
    motion.displacement = std::exchange(motion.velocity, acceleration(scene, motion));
    c.push_back(-sigma * motion.velocity[mass] / (factorial * speed));
    for (double &amplitude : scene.amplitude) amplitude *= scene.omega;
    motion.instant.phase += quarter;
  }
  if (!(c[1] < 0.0 && c[2] > 0.0)) return std::nullopt;  // not pressed at the impact, or for good
  double t = -c[1] / (2.0 * c[2]), value = 0.0;
  for (int iterate = 0; iterate < 40; ++iterate) {
    double slope = 0.0, curvature = 0.0;
    value = 0.0;
    for (std::size_t k = c.size(); k-- > 0;) {
      curvature = curvature * t + 2.0 * slope;
      slope = slope * t + value;
      value = value * t + c[k];
    }
    const double step = -slope / curvature;
    if (!(t + step > 0.0)) return std::nullopt;
    t += step;
    if (std::abs(step) < 1e-15 * t) return value;
  }
  return std::nullopt;
}

// The orbit at a distance beyond the border.
struct UnfoldedOrbit {
  double distance = 0.0;
  PeriodicOrbit orbit;
  double chatter = 0.0;             // time from the section to its first impact
  int impacts = 0;                  // of the chatter that is complete at the border
  std::optional<double> clearance;  // of the flight after the last of them
};

// A border orbit on the side where its chatter is incomplete.
struct Unfolding {
  std::string name;
  int mass;
  double border, side;  // side: +1, -1, away from where the chatter is complete
  int periods;
  UnfoldedOrbit nearest;  // 0.9e-10 from the border

  double omega_at(double distance) const {
    return border + side * distance;
  }
  Scene scene_at(double distance) const {
    return paper::stops_of_different_sign(omega_at(distance));
  }
};

// The orbit of an unfolding near `seed`, which is a state at `from`, with the chatter that begins
// near `chatter`. Nothing where there is none, or that chatter is complete.
inline std::optional<UnfoldedOrbit> orbit_at(const Unfolding &of, double distance, MotionState seed,
                                             double from, double chatter) {
  const Scene scene = of.scene_at(distance);
  seed.instant.phase *= of.omega_at(from) / scene.omega;
  UnfoldedOrbit found{distance, {}, 0.0, 0, {}};
  NewtonOptions to_rounding;
  to_rounding.tolerance = 3e-15;  // the default, 1e-13, is 1e-3 of the smallest distances
  try {
    found.orbit = find_periodic_orbit(scene, seed, of.periods, to_rounding);
  } catch (const std::invalid_argument &) {  // the seed is beyond a stop
    return std::nullopt;
  }
  if (!found.orbit.converged) return std::nullopt;
  RunOptions every_impact;
  every_impact.resolve_chatter = 0.0;
  LastImpacts impacts{of.mass};
  stroboscopic_map(scene, found.orbit.state, of.periods, every_impact, impacts);
  const double section = time_of(found.orbit.state.instant, Clock(scene.omega));
  const LastImpacts::Sequence *nearest = nullptr;
  const auto away = [&](const LastImpacts::Sequence &one) {
    return std::abs(one.begin - section - chatter);
  };
  for (const LastImpacts::Sequence &one : impacts.sequences)
    if (nearest == nullptr || away(one) < away(*nearest)) nearest = &one;
  if (nearest == nullptr || nearest->complete) return std::nullopt;
  found.chatter = nearest->begin - section;
  found.impacts = nearest->impacts;
  found.clearance = clearance_after(scene, static_cast<std::size_t>(of.mass - 1), nearest->last);
  return found;
}

// The same from another orbit, predicted to first order.
inline std::optional<UnfoldedOrbit> orbit_at(const Unfolding &of, double distance,
                                             const UnfoldedOrbit &from) {
  const Scene scene = of.scene_at(from.distance);
  const OrbitChange change = orbit_change(scene, from.orbit, {{Parameter::Kind::omega}});
  const double step = of.omega_at(distance) - scene.omega;
  return orbit_at(of, distance, predicted(scene, from.orbit, change, 0, step), distance,
                  from.chatter);
}

// The unfolding of the border orbit of `mass` at omega, known to ten digits; `side` as in
// CurveStart. Throws std::runtime_error where there is none.
inline Unfolding unfolding(const std::string &name, int mass, double omega, double side) {
  const auto found = border_orbit({omega, omega, side < 0.0 ? 1 : 0, side < 0.0 ? 0 : 1}, mass);
  if (!found) throw std::runtime_error(name + ": no border orbit found");
  Unfolding of{name, mass, found->border.parameter.value, -side, found->periods, {}};
  // Across the border as near as possible: farther away another orbit may be nearer.
  constexpr double near = 0.9e-10;
  MotionState seed = found->seed;
  seed.instant.phase *= found->complete / of.omega_at(-near);
  const MotionState orbit = orbit_near(of.scene_at(-near), seed, of.periods);
  for (const FallingSequence &one :
       falling_sequences(of.scene_at(-near), orbit, mass, of.periods)) {
    if (!one.complete) continue;
    const auto beyond = orbit_at(of, near, orbit, -near, one.begin);
    if (!beyond) continue;  // that chatter is complete on both sides
    of.nearest = *beyond;
    return of;
  }
  throw std::runtime_error(name + ": no incomplete chatter beside");
}

// All border orbits of the scene of Figure 2 between 0.25 and 0.5, in that order.
inline std::vector<CurveStart> borders_to_unfold() {
  std::vector<CurveStart> borders;
  for (const CurveStart &start : curve_starts())
    if (start.what == Bifurcation::border_orbit) borders.push_back(start);
  std::sort(borders.begin(), borders.end(),
            [](const CurveStart &a, const CurveStart &b) { return a.x < b.x; });
  return borders;
}

// Where an impact is added: the orbit with one less, followed towards the border, grazes there.
struct AddedImpact {
  int impact;
  double distance, error;
};

// The grazing that ends the orbit `outer` -> `inner` (the same count, both clear, the second nearer
// to the border): by secants of the clearance, each going most of the way that is left. Beside a
// grazing the orbit with the impact may exist, too; met there, the way ends one step earlier.
inline AddedImpact added_impact(const Unfolding &of, UnfoldedOrbit outer, UnfoldedOrbit inner) {
  AddedImpact found{inner.impacts + 1, 0.0, std::numeric_limits<double>::infinity()};
  for (int step = 0; step < 8; ++step) {
    const double slope = (*inner.clearance - *outer.clearance) / (inner.distance - outer.distance);
    const double grazing = inner.distance - *inner.clearance / slope;
    if (!(slope > 0.0 && grazing > 0.0)) break;
    found.error = step == 0 ? inner.distance - grazing : std::abs(grazing - found.distance);
    found.distance = grazing;
    if (found.error < 1e-10 * grazing) break;
    const auto next = orbit_at(of, grazing + 0.05 * (inner.distance - grazing), inner);
    if (!next || next->impacts != inner.impacts || !next->clearance || !(*next->clearance > 0.0))
      break;
    outer = std::exchange(inner, *next);
  }
  return found;
}

// The orbit followed from the nearest one outwards to a distance, every step by a tenth or, where
// the orbit is not found, less; places where it stays lost are passed over, five of them end it.
inline std::vector<UnfoldedOrbit> followed(const Unfolding &of, double farthest) {
  constexpr double whole = 1.1, least = 1.01;  // three points or more for every impact
  std::vector<UnfoldedOrbit> orbits{of.nearest};
  double distance = of.nearest.distance, step = whole;
  for (int lost = 0; lost < 5 && distance * step <= farthest;) {
    const auto next = orbit_at(of, distance * step, orbits.back());
    if (!next && step > least) {
      step = std::sqrt(step);
      continue;
    }
    lost = next ? 0 : lost + 1;
    if (next) orbits.push_back(*next);
    distance *= step;
    step = whole;
  }
  return orbits;
}

// Every impact added on the way from the last of these orbits inwards to the first.
inline std::vector<AddedImpact> added_impacts(const Unfolding &of,
                                              const std::vector<UnfoldedOrbit> &orbits) {
  std::vector<AddedImpact> added;
  for (std::size_t i = orbits.size(); i-- > 1;) {
    if (i + 1 >= orbits.size()) continue;
    const UnfoldedOrbit &outer = orbits[i + 1], &inner = orbits[i], &beyond = orbits[i - 1];
    if (outer.impacts != inner.impacts || beyond.impacts <= inner.impacts) continue;
    if (!outer.clearance || !inner.clearance || !(*inner.clearance > 0.0)) continue;
    const AddedImpact found = added_impact(of, outer, inner);
    if (found.error < 1e-3 * found.distance &&
        (added.empty() || found.impact > added.back().impact))
      added.push_back(found);
  }
  return added;
}

}  // namespace vibro_impact::figures
