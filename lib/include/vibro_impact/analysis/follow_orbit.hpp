/// \file
/// A periodic orbit followed while a parameter changes, through folds and unstable parts, until the
/// branch ends.
///
/// An orbit is a sequence of events: impacts, holds, releases. The unknowns are the parameter, the
/// state just after one of the events, and the times between the events. There is one equation for
/// each event, and the closure after the periods of the orbit. These equations are smooth through a
/// grazing and through events of two masses at one instant. The branch is followed by
/// pseudo-arclength. Its tangent is the null vector of the equations, whose sign cannot turn back.
///
/// A branch ends where the sequence of events changes. Each end fulfils one equation more, is
/// solved together with the orbit to rounding, and so is named by itself. Events of two masses at
/// one instant change places and end nothing, unless the other order has no orbit.
///
/// A flight takes Taylor steps of the fastest mode: a branch with a stiff link of some 1e12 is
/// lost. Minima of gaps and pressing forces are looked for at six points in each of these steps.
/// Two flips or births of tori within a step of the branch may both be missed. A step next to
/// multipliers of about modulus 1 is divided into eight.
#pragma once

#include <vector>

#include "periodic_orbit.hpp"
#include "settle.hpp"
#include "sweep.hpp"

namespace vibro_impact {

/// The kind of a point of a branch. The last nine end it.
enum class BranchPoint {
  orbit,          ///< an orbit between the others
  coincidence,    ///< events of two masses at one instant: their order changes
  fold,           ///< a multiplier is 1 and the parameter turns round
  branching,      ///< a multiplier is 1, as where mirror orbits part; if the parameter turns round,
                  ///< the branch ends, because its mirror image lies beyond
  flip,           ///< a multiplier is -1: the period doubles
  torus,          ///< two complex multipliers have the modulus 1
  end_of_range,   ///< the parameter has reached the end of its range
  closed,         ///< the branch comes back to its first orbit
  graze,          ///< a mass touches a stop without speed
  border_orbit,   ///< a chatter ends where its sticking phase does
  multi_sliding,  ///< a sticking phase splits in two, or two become one
  parent_flip,    ///< the flip of the orbit of half the periods: beyond lies the same branch
  jump,           ///< events of two masses coincide, and their other order has no orbit
  lost,           ///< none of these: PeriodicOrbit::why_not has the reason
  most_points     ///< more points than were asked for would follow
};

/// Returns "orbit", "fold", ..., "end of range", ...
const char *name(BranchPoint kind);

/// An orbit with the value of the parameter, and the counts of its events over one period. Its
/// state lies in the middle of the longest flight. At a special point the parameter has an
/// estimated error. The multipliers do not exist at a graze to which an impact has slowed down. The
/// residual of the orbit is the largest difference of displacements after its periods, by the
/// equations of the branch.
struct OrbitPoint {
  double parameter = 0.0, error = 0.0;
  PeriodicOrbit orbit = {};
  EventCounts counts = {};
  BranchPoint kind = BranchPoint::orbit;
};

struct FollowOptions {
  int periods = 1;         ///< forcing periods of the orbit
  int most_points = 1000;  ///< >= 1
};

/// The orbit of `periods` forcing periods near `guess`, with its counts. If it was not found, its
/// kind is `lost`, and `orbit.why_not` says why. Throws as find_periodic_orbit does.
OrbitPoint find_orbit(const Scene &scene, const MotionState &guess, int periods = 1);

/// Throws std::invalid_argument for a range along which no orbit of the scene is followed: of an
/// initial state, on which no orbit depends, with fewer than two values or no width, or without the
/// value of the scene.
void check_range(const Scene &scene, const Axis &range);

/// The branch of the orbit near `guess`, from the value of the parameter in the scene, at first
/// towards `range.to`, and as far as the orbit leads between the ends of the range. A step is at
/// most as long as the distance of two values of the range. The orbit need not have the periods of
/// the options if it repeats itself sooner. The first point is the orbit itself; the
/// last one ends the branch. Throws std::invalid_argument for what find_periodic_orbit and
/// check_range refuse, and for options out of range.
std::vector<OrbitPoint> follow_orbit(const Scene &scene, const MotionState &guess,
                                     const Axis &range, const FollowOptions &options = {});

}  // namespace vibro_impact
