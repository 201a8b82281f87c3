// The motion at one parameter point as a bifurcation diagram or a sweep shows it. Only what is
// asked for is computed.
#pragma once

#include <optional>
#include <vector>

#include "event_pairs.hpp"
#include "settle.hpp"

namespace vibro_impact {

struct RecordOptions {
  SettleOptions settle = {};
  bool lyapunov = false;           // greatest Lyapunov exponent
  bool pairs = false;              // the pairs of events of Table I that occur
  bool impact_velocities = false;  // every impact faster than `slowest`
  double slowest = 1e-4;           // >= 0
  bool section = false;            // the states at the phase of the start
};

struct OrbitRecord {
  int period = 0;                       // forcing periods; 0: the motion has not settled
  EventCounts counts = {};              // over one period, or 40 of a motion that has not settled
  std::optional<double> lyapunov = {};  // if asked for, and its sign is certain
  std::vector<EventPair> pairs = {};    // if asked for; each once, in the order of Table I
  // If asked for: per mass, in the order of time, the velocities just before the impacts over the
  // same periods as `counts`.
  std::vector<std::vector<double>> impact_velocities = {};
  // If asked for: (x_1 .. x_N, x_1' .. x_N') at the beginning of each forcing period of `counts`.
  std::vector<std::vector<double>> section = {};
  // The state at which the motion settled, or that after SettleOptions::longest periods. It has the
  // phase of the start, and cycle count zero.
  MotionState state = {};
};

// The record of the motion from `start`, or from the initial state of the scene. The Lyapunov
// exponent of a motion that has settled is ln|mu| / (p T), mu its largest Floquet multiplier over
// its period of p forcing periods T. The exponent of any other motion is the mean growth of
// tangents (lyapunov.hpp), if its sign is certain within 1,000 forcing periods. Pairs of events are
// looked for over two periods, so that every sticking phase is whole in one of them. Throws as
// `settle` does, and std::invalid_argument for options out of range.
OrbitRecord record_of(const Scene &scene, const MotionState &start,
                      const RecordOptions &options = {});
OrbitRecord record_of(const Scene &scene, const RecordOptions &options = {});

// A state of a neighbouring scene as a start of this scene, from which a branch of motions is
// followed: masses that are held move with their stops, and masses beyond a stop move to the stop.
// Throws std::invalid_argument for a bad scene and for a state that does not fit the scene.
MotionState start_near(const Scene &scene, MotionState state);

}  // namespace vibro_impact
