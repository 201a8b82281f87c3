/// \file
/// The motion at one parameter point as a bifurcation diagram or a sweep shows it. Only what is
/// asked for is computed.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "event_pairs.hpp"
#include "lyapunov.hpp"
#include "response.hpp"
#include "settle.hpp"

namespace vibro_impact {

struct RecordOptions {
  SettleOptions settle = {};
  bool lyapunov = false;               ///< greatest Lyapunov exponent
  GrowthOptions growth = {};           ///< of a motion that has not settled
  bool pairs = false;                  ///< the pairs of events of Table I that occur
  bool impacts = false;                ///< every impact faster than `slowest`
  std::optional<double> slowest = {};  ///< >= 0; if empty, 1e-4 of the fastest impact
  bool section = false;                ///< the states at the phase of the start
  bool attractor = false;              ///< what same_attractor compares: section and size
  bool response = false;               ///< extremes and root mean square of each displacement
};

struct OrbitRecord {
  int period = 0;           ///< forcing periods; 0: none was found (settle.hpp)
  int approached = 0;       ///< where it is 0: as in SettledMotion
  EventCounts counts = {};  ///< over one period, or 40 of a motion that has not settled
  Smooth<Growth> lyapunov = Smooth<Growth>::none("not asked for");
  std::vector<EventPair> pairs = {};  ///< if asked for; each once, in the order of Table I
  /// If asked for: per mass, in the order of time from the phase of the start on, the impacts over
  /// the same periods as `counts`.
  std::vector<std::vector<Event>> impacts = {};
  /// If asked for: (x_1 .. x_N, x_1' .. x_N') at the phase of the start in each forcing period of
  /// `counts`.
  std::vector<std::vector<double>> section = {};
  double size = 0.0;  ///< of a motion that has settled, to which the error of its orbit refers
  int attractor = 0;  ///< its number among the records of a table, which gives it; 0: none
  std::vector<Response> response = {};  ///< if asked for: of each mass, over the same periods
  /// The state at which the motion settled, or that after SettleOptions::longest periods. It has
  /// the phase of the start, and cycle count zero.
  MotionState state = {};
};

/// The record of the motion from `start`, or from the initial state of the scene. The Lyapunov
/// exponent of a motion that has settled is ln|mu| / (p T), mu its largest Floquet multiplier over
/// its period of p forcing periods T; its error comes from the 1e-10 to which it has settled. The
/// exponent of any other motion is the mean growth of tangents (lyapunov.hpp). Pairs of events are
/// looked for over two periods, so that every sticking phase is whole in one of them. Throws as
/// `settle` does, and std::invalid_argument for options out of range.
OrbitRecord record_of(const Scene &scene, const MotionState &start,
                      const RecordOptions &options = {});
OrbitRecord record_of(const Scene &scene, const RecordOptions &options = {});

/// True if two motions of one scene have settled on the same orbit: a state of one is a state of
/// the other, in any of its forcing periods, within 1e-9 of the larger size of the two. Orbits are
/// found to some 1e-13 of their size. An orbit and its mirror image are two attractors. If an orbit
/// has an impact at the phase of the start to within its error, its states there may lie before or
/// after the impact, and it may count as two. The records have the sections that
/// RecordOptions::attractor asks for. Throws std::invalid_argument for a bad scene and for states
/// of another chain.
bool same_attractor(const Scene &scene, const OrbitRecord &one, const OrbitRecord &other);

/// The record of one point of a sweep, or the reason why there is none.
struct PointRecord {
  std::optional<OrbitRecord> record = {};
  std::string reason = {};  ///< one line where the scene was refused or the run was given up
  bool refused = false;     ///< there is none because the scene was refused
};

/// The record of the motion from the initial state of the scene, or near the state of a record
/// `before`, for a sweep that follows a branch. Then the initial state may lie beyond the stops.
PointRecord point_record(const Scene &scene, const RecordOptions &options,
                         const std::optional<OrbitRecord> &before = {});

/// A reason with # for every number in it, by which points are grouped.
std::string kind_of_reason(const std::string &reason);

/// A state of a neighbouring scene as a start of this scene, from which a branch of motions is
/// followed: masses that are held move with their stops, and masses beyond a stop move to the stop.
/// Throws std::invalid_argument for a bad scene and for a state that does not fit the scene.
MotionState start_near(const Scene &scene, MotionState state);

}  // namespace vibro_impact
