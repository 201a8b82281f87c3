// Error against run time as it was measured with every method: the table that the committed
// pictures are drawn from, and what the documents say of it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reference/truth/table_reader.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace vibro_impact::comparison {

// A run that made all events: its setting, the largest error of an event time, and the processor
// time in microseconds, for a forcing period or for a problem shorter than that.
struct Measured {
  std::string problem, method;
  double setting, error, microseconds;
};

// The runs in a table of the driver error_vs_runtime. Those that failed are left out. Throws
// std::runtime_error naming a table that cannot be read.
std::vector<Measured> read_measured(const std::string &path);

// The fastest run on a problem with an error of at most `error`, of one of these methods; nothing
// if there is none.
std::optional<Measured> fastest(const std::vector<Measured> &runs, const std::string &problem,
                                const std::vector<std::string> &methods, double error);

// The table of README.md. For every motion and every error it has the time of the fastest
// general-purpose stepper, relative to the library. The errors are those at which people work.
std::vector<truth::Cells> rows_of_steppers(const std::vector<Measured> &runs);

// The table of the page of the methods: the time of every method in ten periods of Figure 2,
// relative to the library, whose time is in microseconds.
std::vector<truth::Cells> rows_of_methods(const std::vector<Measured> &runs);

}  // namespace vibro_impact::comparison
