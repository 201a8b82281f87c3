// The functions of periodic_orbit.hpp, of a simulation whose scene has been checked and whose
// options are those of the runs. Each starts the simulation anew.
#pragma once

#include "vibro_impact/analysis/periodic_orbit.hpp"

namespace vibro_impact {

template <std::derived_from<Recorder>... Recorders>
MotionState stroboscopic_map(Simulation &simulation, const MotionState &start, int periods,
                             Recorders &...recorders) {
  const double until = time_after(simulation.scene(), start, periods);
  simulation.start_from(start);
  MotionState state = require_complete(simulation.advance(until, recorders...)).state;
  state.instant = start.instant;
  return state;
}

StroboscopicImage stroboscopic_map_and_derivative(Simulation &simulation, const MotionState &start,
                                                  int periods);

MotionState at_quiet_phase(Simulation &simulation, const MotionState &start);

}  // namespace vibro_impact
