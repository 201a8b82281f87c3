// The analysis, whole: what is asked of many runs. The simulation stands in vibro_impact.hpp.
#pragma once

#include "bifurcation_curve.hpp"
#include "border_orbit.hpp"
#include "continuation.hpp"
#include "event_pairs.hpp"
#include "hold_force.hpp"
#include "locate.hpp"
#include "lyapunov.hpp"
#include "matrix.hpp"
#include "multi_sliding.hpp"
#include "orbit_change.hpp"
#include "orbit_record.hpp"
#include "parameter.hpp"
#include "periodic_orbit.hpp"
#include "settle.hpp"
#include "sweep.hpp"
#include "tangent.hpp"
