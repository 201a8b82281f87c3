// The table of the totals of the stops.
#pragma once

#include "vibro_impact/analysis/table.hpp"
#include "vibro_impact/analysis/totals.hpp"

namespace vibro_impact::runner {

// A row for each stop of the scene.
Table table_of(const TotalsRecorder &totals, const Scene &scene);

}  // namespace vibro_impact::runner
