// Everything a user of the library includes.
#pragma once

#include "border_orbit.hpp"
#include "event_pairs.hpp"
#include "hold_force.hpp"
#include "impact_family.hpp"
#include "locate.hpp"
#include "lyapunov.hpp"
#include "multi_sliding.hpp"
#include "orbit_change.hpp"
#include "orbit_record.hpp"
#include "parameter.hpp"
#include "periodic_orbit.hpp"
#include "settle.hpp"
#include "simulate.hpp"
#include "sweep.hpp"
#include "table.hpp"
#include "tangent.hpp"
