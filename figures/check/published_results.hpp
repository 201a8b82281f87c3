// Quantities of the results that other authors printed, as the library computes them. Their rows
// stand in reference/tables/checked_numbers.csv, their sources in reference/README.md.
#pragma once

#include <complex>
#include <utility>
#include <vector>

#include "library_engine.hpp"
#include "vibro_impact/analysis/analysis.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace vibro_impact::published {

using numbers::Arguments;

// The multiplier nearest to `target`: -1 at a period doubling, 1 at a fold.
double multiplier_near(double target, const std::vector<std::complex<double>> &multipliers);

// The motion from an impact at `time` with `speed`, far from that impact: of a ball on a table
// where a weight g is given, of a mass on a spring elsewhere, between two stops where `wall` is.
std::pair<Scene, MotionState> after_impact(const Arguments &p);

// A periodic orbit of one impact at each stop in n forcing periods. `impact` is the first.
struct OneImpactOrbit {
  Scene scene;
  PeriodicOrbit orbit;
  Event impact;
};

// Finds the orbit by Newton's method on the stroboscopic map, from an impact near `time` with about
// `speed`. Throws std::runtime_error if there is no such orbit.
OneImpactOrbit one_impact_orbit(const Arguments &p);

void add_quantities(numbers::Quantities<figures::LibraryEngine> &all);

}  // namespace vibro_impact::published
