// Pictures of tables, which gnuplot draws by plot.gp.
#pragma once

#include <string>
#include <vector>

namespace vibro_impact::runner {

// The option that asks for a picture, with its file.
struct Picture {
  std::string option, path;
};

// Refuses a picture if its table is no file, if gnuplot is not installed or cannot write this
// format, or if the script of the picture is missing. `table` is the file given with `of`.
void check_picture(const Picture &picture, const std::string &of, const std::string &table);

// Draws a picture from its tables, which are written by now. `kind` names the picture in plot.gp,
// and `arguments` are those of this kind. Throws std::runtime_error with the last line of gnuplot.
void draw(const Picture &picture, const std::string &kind,
          const std::vector<std::string> &arguments);

}  // namespace vibro_impact::runner
