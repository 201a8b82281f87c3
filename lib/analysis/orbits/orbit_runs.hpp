// The functions of periodic_orbit.hpp, of a simulation whose scene has been checked and whose
// options are those of the runs. Each starts the simulation anew.
#pragma once

#include "vibro_impact/analysis/periodic_orbit.hpp"

namespace vibro_impact {

StroboscopicImage stroboscopic_map_and_derivative(Simulation &simulation, const MotionState &start,
                                                  int periods);

MotionState at_quiet_phase(Simulation &simulation, const MotionState &start);

}  // namespace vibro_impact
