// What a diagram or an atlas shows of the motion at one parameter point. Only what is asked for is
// computed.
#pragma once

#include <optional>
#include <vector>

#include "event_pairs.hpp"
#include "settle.hpp"

namespace vibro_impact {

struct RecordOptions {
  SettleOptions settle;
  int counted = 40;           // forcing periods over which a motion that does not settle is
                              // recorded, after SettleOptions::longest, >= 1
  bool lyapunov = false;      // greatest Lyapunov exponent
  int longest_if_stable = 0;  // a motion that has not settled after SettleOptions::longest, but
                              // whose exponent is negative, gets as many forcing periods more;
                              // 0: none, else the exponent must be asked for
  bool pairs = false;         // the pairs of Table I that occur
  bool impact_velocities = false;  // every impact faster than `slowest`
  double slowest = 1e-4;           // >= 0
};

// Forcing periods integrated: counts of work.
struct RecordWork {
  long long settling = 0;       // until the motion has settled, or to the full length
  long long recorded = 0;       // over which counts, velocities and pairs were taken after that
  long long with_tangents = 0;  // followed with tangents
};

struct OrbitRecord {
  int period = 0;                  // forcing periods; 0: none
  EventCounts counts;              // over one period, or RecordOptions::counted forcing periods
  std::optional<double> lyapunov;  // if asked for, and decided
  std::vector<EventPair> pairs;    // each once, in the order of Table I; if asked for
  // Velocities just before the impacts over these periods, per mass, in the order of time; if asked
  // for.
  std::vector<std::vector<double>> impact_velocities;
  MotionState state;  // where the motion settled, or stood after the full length: at the phase of
                      // the start, cycle count zero
  RecordWork work;
};

// The record of the motion from `start`, or from the initial state of the scene. The Lyapunov
// exponent of a motion that has settled is ln|mu| / (p T), mu its largest Floquet multiplier over
// its period of p forcing periods T; that of any other the mean growth of tangents, if its sign is
// certain (lyapunov.hpp) within 1,000 forcing periods. Pairs of events are looked
// for over two periods, so that every sticking phase is whole in one of them. Throws as `settle`
// does, and std::invalid_argument for options out of range.
OrbitRecord record_of(const Scene &scene, const MotionState &start,
                      const RecordOptions &options = {});
OrbitRecord record_of(const Scene &scene, const RecordOptions &options = {});

}  // namespace vibro_impact
