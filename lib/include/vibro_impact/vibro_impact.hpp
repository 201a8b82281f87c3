// The simulation, whole. The analysis of many runs stands beside it: analysis/analysis.hpp.
#pragma once

#include "counters.hpp"
#include "impact_law.hpp"
#include "instant.hpp"
#include "record.hpp"
#include "scene.hpp"
#include "simulate.hpp"
#include "table.hpp"
