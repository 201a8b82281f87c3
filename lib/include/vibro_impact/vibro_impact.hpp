/// \file
/// All headers of the simulation. analysis/analysis.hpp has those of the analysis of many runs.
#pragma once

#include "counters.hpp"
#include "event.hpp"
#include "impact_law.hpp"
#include "instant.hpp"
#include "record.hpp"
#include "scene.hpp"
#include "scene_fields.hpp"
#include "scene_text.hpp"
#include "simulate.hpp"
