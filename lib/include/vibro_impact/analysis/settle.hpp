/// \file
/// A motion followed, forcing period by forcing period, until an orbit is found that attracts it.
///
/// At the section of the stroboscopic map (the phase of the start) the state z_n is compared with
/// those before it. The distance of two states is a length: with the frequency w of a mass between
/// neighbours that stand still (Omega on no spring), it is the norm of all differences of x and
/// v/w. Newton's method looks for an orbit of p periods where a state comes near to that of p
/// periods before, at a phase away from events. A motion has settled on this orbit z* if
///   - the orbit is stable, and attracts the motion from where it is: what the image of the motion
///     differs by from its image by the derivative, |P(z) - z* - DP (z - z*)|, is at most
///     (1 - |mu|) |z - z*| / 10. Or the orbit is not unstable, and the motion has returned within
///     1e-10 of its size, as where a motion without damping repeats;
///   - the orbit has the same events with every stop nearer by ten distances |z - z*|. Next to a
///     grazing, what is left may bring an impact.
/// Otherwise the motion is followed further. The period is the least divisor of p after which the
/// orbit itself returns. Nothing proves that the motion stays: the boundary of a basin within ten
/// distances that no other event shows would deceive both conditions.
///
/// A motion that has not settled may be irregular, or have a period above the largest one asked
/// for, or be on its way: then Newton's method has found a stable orbit that its latest return
/// brought it nearer to.
#pragma once

#include <vector>

#include "periodic_orbit.hpp"

namespace vibro_impact {

struct SettleOptions {
  RunOptions run = {};
  int longest = 400;        ///< forcing periods after which the motion counts as not settling, >= 1
  int largest_period = 32;  ///< that is looked for, from 1 to 1000 forcing periods
};

/// The events of some whole forcing periods, per mass.
struct EventCounts {
  int periods = 0;             ///< forcing periods counted over
  std::vector<int> impacts;    ///< without those of complete chatters, which are infinitely many
  std::vector<int> sticks;     ///< sticking phases begun
  bool dual_sticking = false;  ///< two or more masses stick at the same time
};

/// The counts of the events of whole forcing periods, of a motion that repeats after them. `held`
/// is the contact mode at their start. Throws std::invalid_argument for a bad scene, for periods <
/// 1, and for a contact mode or an event of a mass or stop that the scene does not have.
EventCounts counts_of(const Scene &scene, const std::vector<Event> &events, int periods,
                      const Held &held);

struct SettledMotion {
  int period = 0;           ///< forcing periods; 0: none was found up to `largest_period`
  int approached = 0;       ///< where it is 0: the period of the orbit that the motion is on its
                            ///< way to; 0: of none, as of an irregular motion
  int periods_run = 0;      ///< forcing periods integrated
  EventCounts counts = {};  ///< over one period of the orbit; empty where `period` is 0
  /// The orbit at a section away from events; not found where `period` is 0.
  PeriodicOrbit orbit = {};
  /// The states of the orbit at the phase of the start; empty where `period` is 0.
  std::vector<MotionState> section = {};
  /// The last of these, or the latest state of a motion that has not settled. The forcing period
  /// has the number 0.
  MotionState state = {};
};

/// Follows the motion from `start`, or from the initial state of the scene, until it has settled.
/// Throws std::invalid_argument for what `simulate` refuses, for a scene without a forcing period
/// and for options out of range, and std::runtime_error when the run is given up.
SettledMotion settle(const Scene &scene, const MotionState &start,
                     const SettleOptions &options = {});
SettledMotion settle(const Scene &scene, const SettleOptions &options = {});

}  // namespace vibro_impact
