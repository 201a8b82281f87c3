/// \file
/// All headers of the analysis: what is asked of a motion and of many runs. vibro_impact.hpp has
/// the simulation.
#pragma once

#include "event_pairs.hpp"
#include "follow_orbit.hpp"
#include "locate.hpp"
#include "lyapunov.hpp"
#include "matrix.hpp"
#include "natural_modes.hpp"
#include "orbit_record.hpp"
#include "parameter.hpp"
#include "periodic_orbit.hpp"
#include "pressing_force.hpp"
#include "response.hpp"
#include "settle.hpp"
#include "smooth.hpp"
#include "sweep.hpp"
#include "table.hpp"
#include "totals.hpp"
