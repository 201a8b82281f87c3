// Event-driven simulation with plain means: sample the closed form, bracket each zero, narrow the
// bracket down, and resolve every single impact.
//
// Nothing but scenes and kinds of events is shared with the library on purpose, neither code nor
// method. In particular a chatter sequence is not taken to its limit here: its impacts are computed
// one by one until the speed is below 1e-20. At such a speed v the flight is some v^2 = 1e-40 high,
// and the gap, a difference of numbers of order one known to 1e-50, still has ten digits (the
// cancellation would take over near sqrt(1e-50) = 1e-25). There, if the force presses the mass into
// its stop, it sticks. The chatter that is left out lasts some 1e-19; that is the error of the
// generator.
#pragma once

#include "stops.hpp"
#include "vibro_impact/event.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace vibro_impact_reference {

/// The thresholds of the generator.
struct Resolution {
  Real speed_floor = Real("1e-20");  // a chatter is followed down to this speed
  RootSearch roots = {};             // relative to the time since the last event
};

/// The thresholds with chatter followed down to `floor`, and zeros narrowed down as the flights of
/// such a chatter need, by the faster search.
Resolution resolution_down_to(const Real &floor);

/// A hold force below this counts as zero: no stick.
inline const Real pressing_floor = Real("1e-30");

using vibro_impact::EventKind;

struct Event {
  Real time;
  std::size_t mass;  // from 0
  EventKind kind;
  Real velocity_before;
  Real velocity_after;
  std::vector<bool> stuck;  // per mass, after the event
  // A stick that ends a chatter has here the duration of the flights left out, 2 v / a (1 + r + r^2
  // + ...). It is off by the relative change of the acceleration a over them, which is as small as
  // they are.
  Real left_out = 0;
};

/// The masses that stick, as `1+2`; `-` if none does.
std::string contact_mode(const std::vector<bool> &stuck);

/// A piece of smooth motion.
struct Piece {
  Flow flow;
  Real duration;
};

/// The events and pieces of a simulation, in the order of time, and the contact modes it has met.
struct Run {
  std::vector<Event> events = {};
  std::vector<Piece> pieces = {};
  Eigensystems known = {};
};

/// The state at t = 0; a mass that starts on a stop hits it, rests on it, or leaves it, as its
/// speed and the force say; where the force is zero (all at rest, stop at zero) it is decided by
/// trial.
State initial_state(const Scene &scene, const Resolution &resolution, Run &run);

/// Carries a state on to the end time of the scene and appends every event and every piece of
/// motion to the run.
void advance(const Scene &scene, State &state, Run &run, const Resolution &resolution = {});

/// Simulates a scene from t = 0 to its end time. Events of several masses at one instant carry the
/// same time. Throws std::runtime_error if a bounce under a vanishing hold force becomes too slow
/// for the working precision.
Run simulate(const Scene &scene, const Resolution &resolution = {});

}  // namespace vibro_impact_reference
