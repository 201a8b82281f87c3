// The plain event-driven scheme, as papers on impact oscillators describe it: closed form between
// the events, samples at a fixed step, bisection of the step in which a mass reaches a stop or a
// hold force changes sign, the impact law applied to the velocity, and sticking below a threshold
// of speed.
//
// What the library is compared with; no algorithm is shared. Its weak point: the gap is read off
// the closed form, and so is lost to cancellation once a flight is lower than the rounding of x,
// at speeds near the root of that. A contact that begins and ends between two samples is missed.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "vibro_impact/record.hpp"

namespace vibro_impact::plain {

// At most 8 masses.
using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 8, 1>;

// All non-dimensional. A mass sticks when it reaches its stop slower than `threshold` (0: never)
// and its hold force presses it there. The run ends early after `max_impacts`, sticks included.
struct Options {
  double step = 0.01, threshold = 0.0;
  long long max_impacts = 1'000'000;
};

struct PlainEvent {
  double time;
  int mass;  // from 1
  EventKind kind;
  double velocity_before;
};

struct Result {
  std::vector<PlainEvent> events;
  long long evaluations = 0;  // of the closed form, all masses at one time
  long long impacts = 0;      // sticks included
  bool capped = false;        // ended by max_impacts
  double time = 0.0;          // reached
  Vector displacement, velocity;
};

// Runs `scene` from its start to time `until`. Throws std::invalid_argument for a scene that is
// not valid or has an overdamped mode.
Result run(const Scene &scene, double until, const Options &options);

}  // namespace vibro_impact::plain
