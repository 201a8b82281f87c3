// Pictures of tables, which gnuplot draws by plot.gp.
#pragma once

#include <string>
#include <vector>

#include "files.hpp"

namespace vibro_impact::runner {

// Refuses a picture if its table is no file, if gnuplot is not installed or cannot write this
// format, or if the script of the picture is missing.
void check_picture(const Output &picture, const Output &table);

// Draws a picture of this kind, which shows some masses or a column, from its tables, which are
// written by now, and with further words; plot.gp says which. Throws std::runtime_error with the
// last line of gnuplot.
void draw(const Output &picture, const std::string &kind, const std::string &content,
          const std::vector<Output> &tables, const std::vector<std::string> &words);

}  // namespace vibro_impact::runner
