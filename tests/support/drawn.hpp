// The drawing of a driver and its gnuplot script: the points of every curve, and the colours and
// texts of every panel. The script is run twice, for the points as text (exact to six digits) and
// for a picture in SVG, which has colours and texts as text.
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

namespace vibro_impact::testing {

using Point = std::array<double, 2>;

struct Curve {
  std::string title;   // in the key; empty: none
  std::string colour;  // as SVG has it, rgb(red, green, blue)
  std::vector<Point> points = {};
};

struct Panel {
  std::vector<Curve> curves = {};
  std::vector<std::string> texts = {};  // tick labels, names of axes, the panel's letter
};

void run(const std::string &command);

// The columns of a table by their names. Only cells that are numbers count.
using Columns = std::map<std::string, std::vector<double>>;

Columns columns_of(const std::string &path);

// The texts of a picture in SVG, without their fonts, and where each stands across the picture.
// Empty texts are left out. gnuplot writes each text in a line.
std::multimap<std::string, double> texts_of(const std::string &path);

// The drawing that the script of a figure makes from the tables that its driver writes to a folder.
std::vector<Panel> drawn(const std::string &figure, const std::string &folder);

// The colour of a line type of style.gp, as SVG has it.
std::string colour_of_line_type(int type);

}  // namespace vibro_impact::testing
