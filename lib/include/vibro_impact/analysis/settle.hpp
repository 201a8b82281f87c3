// A motion followed, forcing period by forcing period, until it has settled, and its events
// counted.
//
// At the section of the stroboscopic map (the phase of the start) the state z_n is compared with
// that p periods before. With the distance d_n of the two and the contraction mu = d_n / d_(n-p),
// what is still to come is estimated by d_n mu / (1 - mu), the rest of the geometric sequence, and
// by no less than d_n: a single small ratio may be chance. The distance is a length, the largest
// over the masses of the amplitude of vibration that is left, (x^2 + (v/w)^2)^(1/2) for a mass of
// frequency w between neighbours that stand still (Omega on no spring). A component by itself is
// small once in every turn of the state, however far the orbit.
//
// A motion counts as settled, of period p, when the estimate lies below 1e-10 of its own amplitude
// at p sections in a row. The amplitude is the largest at the sections of the second half of the
// motion. Where all states q periods apart, q a divisor of p, are within ten tolerances and all p
// periods repeat the events of q, the period is q. Where the states are within 10,000 tolerances it
// is not decided yet: a motion that turns around its orbit comes near to itself after some number
// of periods long before it has settled. Impacts of a complete chatter are not compared: a run
// reports only as many of them as it needed to find the limit.
//
// Next to a grazing, what is still to come may bring an impact. A period is accepted if its periods
// have the same events with every stop nearer by ten times the largest distance or estimate, which
// counts as no less than 1e-13 of the amplitude where it is not zero. Otherwise the motion is
// followed further until that distance is small enough, or is left undecided.
//
// A motion that has not settled may be irregular, or have a period above the largest one asked for,
// or be on its way. It is on its way to an orbit of period p if period p was left undecided at
// last, or if its distances p periods apart fell to half over the last doubling of its length.
#pragma once

#include <vector>

#include "vibro_impact/simulate.hpp"

namespace vibro_impact {

struct SettleOptions {
  RunOptions run = {};
  int longest = 400;        // forcing periods after which the motion counts as not settling, >= 1
  int largest_period = 32;  // that is looked for, from 1 to 1000 forcing periods
};

// The events of some whole forcing periods, per mass.
struct EventCounts {
  int periods = 0;             // forcing periods counted over
  std::vector<int> impacts;    // without those of complete chatters, which are infinitely many
  std::vector<int> sticks;     // sticking phases begun
  bool dual_sticking = false;  // two or more masses stick at the same time
};

// The counts of the events of whole forcing periods, of a motion that repeats after them. `held` is
// the contact mode at their start. Throws std::invalid_argument for a bad scene, for periods < 1,
// and for a contact mode or an event of a mass or stop that the scene does not have.
EventCounts counts_of(const Scene &scene, const std::vector<Event> &events, int periods,
                      const Held &held);

struct SettledMotion {
  int period = 0;           // forcing periods; 0: none was found up to `largest_period`
  int approached = 0;       // where it is 0: the period of the orbit that the motion is on its way
                            // to; 0: of none, as of an irregular motion
  int periods_run = 0;      // forcing periods integrated
  MotionState state = {};   // at the last section, cycle count as it stands
  EventCounts counts = {};  // of the last `period` periods; empty where it is 0
  std::vector<MotionState> section = {};  // the states at their ends; empty where it is 0
  double fastest_impact = 0.0;            // speed, over the last periods
  Simulation simulation;                  // stands at the last section
};

// Follows the motion from `start` until it has settled. Throws std::invalid_argument for what
// `simulate` refuses, for a scene without a forcing period and for options out of range, and
// std::runtime_error when the run is given up.
SettledMotion settle(const Scene &scene, const MotionState &start,
                     const SettleOptions &options = {});

}  // namespace vibro_impact
