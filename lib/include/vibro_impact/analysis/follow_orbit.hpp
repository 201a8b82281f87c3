// A periodic orbit followed while a parameter changes, through folds and unstable parts, until the
// branch ends.
//
// The unknowns are the free coordinates z at the section and the parameter q. The branch of P(z; q)
// = z is followed by pseudo-arclength: a step of length s along the chord of the latest two points,
// then Newton's method with z and q on the plane normal to the chord. All lengths are relative,
// those of z to the amplitude of the first orbit and those of q to its range. The derivative by z
// is that of stroboscopic_map_and_derivative. The derivative by q is a difference of two maps: it
// decides how fast Newton's method converges, and not to which orbit. A state counts as an orbit
// when the map returns to it within 1e-13 of the amplitude, or within 1e-10 where rounding keeps
// the distance from falling further, as next to a graze. The section keeps its part of the period
// while omega changes, and moves away from events that come near it.
//
// An orbit is smooth in q as long as its events are the same. A branch ends where they change. The
// kind of the end is that of which the last orbit comes nearest to the condition: an impact without
// speed or a gap without width (graze), a sticking phase without length (border orbit), or a
// vanishing pressing force within a sticking phase (multi-sliding).
#pragma once

#include <vector>

#include "periodic_orbit.hpp"
#include "settle.hpp"
#include "sweep.hpp"

namespace vibro_impact {

// The kind of a point of a branch. The last seven end it.
enum class BranchPoint {
  orbit,          // an orbit between the others
  fold,           // a multiplier is 1 and the parameter turns round
  branching,      // a multiplier is 1 and the parameter goes on, as where mirror orbits part
  flip,           // a multiplier is -1: the period doubles
  torus,          // two complex multipliers have the modulus 1
  end_of_range,   // the parameter has reached the end of its range
  graze,          // a mass touches a stop without speed
  border_orbit,   // a sticking phase has no length
  multi_sliding,  // a sticking phase is about to split
  lost,           // the orbit was not found, or another condition ends the branch
  most_points     // more points than were asked for would follow
};

// Returns "orbit", "fold", ..., "end of range", ...
const char *name(BranchPoint kind);

// An orbit with the value of the parameter, and the counts of its events over one period.
struct OrbitPoint {
  double parameter = 0.0;
  PeriodicOrbit orbit = {};
  EventCounts counts = {};
  BranchPoint kind = BranchPoint::orbit;
};

struct FollowOptions {
  int periods = 1;         // forcing periods of the orbit
  int most_points = 1000;  // >= 1
};

// The orbit of `periods` forcing periods near `guess`, with its counts. If it was not found, its
// kind is `lost`, and `orbit.why_not` says why. Throws as find_periodic_orbit does.
OrbitPoint find_orbit(const Scene &scene, const MotionState &guess, int periods = 1);

// Throws std::invalid_argument for a range along which no orbit of the scene is followed: of an
// initial state, on which no orbit depends, with fewer than two values or no width, or without the
// value of the scene.
void check_range(const Scene &scene, const Axis &range);

// The branch of the orbit near `guess`, from the value of the parameter in the scene, at first
// towards `range.to`, and as far as the orbit leads between the ends of the range. A step is at
// most as long as the distance of two values of the range. The first point is the orbit itself; the
// last one ends the branch. Throws std::invalid_argument for what find_periodic_orbit and
// check_range refuse, and for options out of range.
std::vector<OrbitPoint> follow_orbit(const Scene &scene, const MotionState &guess,
                                     const Axis &range, const FollowOptions &options = {});

}  // namespace vibro_impact
