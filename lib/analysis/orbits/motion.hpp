// A motion over whole forcing periods: the one record from which the analysis reads everything.
//
// A run is recorded once, as knots: the state at the start, after each event, at samples that were
// asked for, and at the end. Counts, pairs, tangents, minima and the residual of an orbit are
// functions of these knots. A motion begins and ends at its section. `quiet_section` puts the
// section where no event and no unfinished chatter is near.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "motion_state.hpp"
#include "vibro_impact/analysis/event_pairs.hpp"
#include "vibro_impact/simulate.hpp"

namespace vibro_impact {

// The motion just after an event, or at a sample, at the start or at the end.
struct Knot {
  MotionState state;
  std::optional<Event> event = {};
};

struct Motion {
  Scene scene;
  RunOptions options;
  int periods = 1;
  std::vector<Knot> knots = {};  // the first and the last are the start and the end

  const MotionState &start() const {
    return knots.front().state;
  }
  const MotionState &end() const {
    return knots.back().state;
  }
};

// Times of samples: a phase of each period, or equal distances. Neither by default.
struct Samples {
  double phase = -1.0, every = infinity;
};

// The motion from `start`, whose period gets the number 0, over whole forcing periods.
Motion motion_of(const Scene &scene, MotionState start, int periods, const RunOptions &options = {},
                 const Samples &samples = {});
// The motion from where a simulation stands, in the state `from`, over whole forcing periods.
Motion next_motion(Simulation &simulation, const MotionState &from, int periods,
                   const RunOptions &options, const Samples &samples = {});

// The middle of the longest interval between events in the first period, as a state. No section
// lies between the last resolved impact of a chatter and its stick.
MotionState quiet_section(const Motion &motion);
// The states at the samples.
std::vector<MotionState> samples_of(const Motion &motion);
std::vector<Event> events_of(const Motion &motion);
// The pairs of the events of a motion (event_pairs.hpp), with its contact mode at the start.
std::vector<PairedEvents> pairs_of(const Motion &motion);
// The fastest speed of an impact.
double fastest_impact(const Motion &motion);
// The largest length of a state of the motion, the unit of its tolerances.
double size_of(const Motion &motion);

// The state as lengths: x and v / w of all masses, with w of `local_frequencies`. The distance of
// two states is the norm of their difference.
Eigen::VectorXd lengths(const std::vector<double> &frequencies, const MotionState &state);

// The unit of each coordinate in which it is such a length: 1 of x and w of v.
Eigen::VectorXd length_units(const Scene &scene);

// The scene with its own start inside its stops: a motion from another start does not use it.
Scene with_start_inside(Scene scene);

}  // namespace vibro_impact
