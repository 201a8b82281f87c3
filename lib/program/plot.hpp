// A picture of a run, which gnuplot draws from the tables as plot.gp says, which is installed: the
// displacement of each mass over time, its stops, impacts and the phases in which it sticks.
#pragma once

#include "options.hpp"
#include "output.hpp"

namespace vibro_impact::runner {

// Throws std::invalid_argument when the run writes no table of samples to be drawn, and when
// gnuplot is not there or does not draw such a file.
void check_plot(const Request &request);

// Draws the tables of the run, which have their names by now. Throws std::runtime_error.
void draw(const Request &request, const Scene &scene, Output &picture);

}  // namespace vibro_impact::runner
