// A picture of a run: the displacement of each mass over time, its stops, its impacts and the
// phases in which it sticks. Gnuplot draws it from the tables of the run by plot.gp, which is
// installed.
#pragma once

#include "options.hpp"

namespace vibro_impact::runner {

// Throws std::invalid_argument when the run writes no table of samples to draw from, and when
// gnuplot is not there or cannot draw a file of that kind.
void check_plot(const RunRequest &request);

// Draws the tables of the run, which are written by now. Throws std::runtime_error.
void draw(const RunRequest &request);

}  // namespace vibro_impact::runner
