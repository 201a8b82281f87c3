// The drawing of a driver and its gnuplot script: the points of every curve, and the colours and
// texts of every panel. The script is run twice, for the points as text (exact to six digits) and
// for a picture in SVG, which has colours and texts as text.
#pragma once

#include <array>
#include <cstdlib>
#include <fstream>
#include <map>
#include <regex>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "reference/truth/table_reader.hpp"

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

inline void run(const std::string &command) {
  if (std::system(command.c_str()) != 0) throw std::runtime_error(command + ": failed");
}

// The columns of a table by their names. Only cells that are numbers count.
using Columns = std::map<std::string, std::vector<double>>;

inline Columns columns_of(const std::string &path) {
  std::ifstream file = truth::opened(path);
  std::string header;
  std::getline(file, header);
  const std::vector<std::string> names = truth::cells_of(header);
  Columns columns;
  for (const auto &cells : truth::read_rows(path, names.size()))
    for (std::size_t i = 0; i < names.size(); ++i)
      if (const auto value = truth::as_number(cells[i])) columns[names[i]].push_back(*value);
  return columns;
}

// The curves as gnuplot's `set table` writes them: x, y, ... and `u` at the end for no point.
inline std::vector<Panel> panels_in_table(const std::string &path) {
  std::vector<Panel> panels;
  std::ifstream file = truth::opened(path);
  for (std::string line; std::getline(file, line);) {
    const std::string title = "# Curve title: \"";
    if (line.starts_with("# Curve 0 of")) panels.emplace_back();
    if (line.starts_with(title))
      panels.back().curves.back().title = line.substr(title.size(), line.size() - title.size() - 1);
    else if (line.starts_with("# Curve "))
      panels.back().curves.emplace_back();
    Point point{};
    std::istringstream words(line);
    if (!line.starts_with('#') && !line.ends_with('u') && words >> point[0] >> point[1])
      panels.back().curves.back().points.push_back(point);
  }
  return panels;
}

// Adds what the picture tells. Its group gnuplot_plot_2b is the second curve of the second panel
// (an opaque key draws them twice); tick labels and letter of a panel come before its first curve.
inline void add_picture(std::vector<Panel> &panels, const std::string &path) {
  const std::regex plot("id=\"gnuplot_plot_([0-9]+)([a-z])"), text("<tspan[^>]*> *([^<]*)<"),
      colour("(?:stroke|color|fill) ?= ?'(rgb\\([^)]*\\))");
  std::vector<std::string> texts;  // since the last curve
  Curve *curve = nullptr;
  std::ifstream file = truth::opened(path);
  std::smatch found;
  for (std::string line; std::getline(file, line);) {
    if (std::regex_search(line, found, plot)) {
      Panel &panel = panels.at(static_cast<std::size_t>(found[2].str().front() - 'a'));
      if (panel.texts.empty()) panel.texts = texts;
      texts.clear();
      curve = &panel.curves.at(std::stoul(found[1]) - 1);
    } else if (std::regex_search(line, found, text)) {
      texts.push_back(found[1]);
    } else if (curve != nullptr && curve->colour.empty() &&
               std::regex_search(line, found, colour)) {
      curve->colour = found[1];
    }
  }
}

// A text of a picture in SVG, without its fonts, and where it stands across the picture.
struct PlacedText {
  std::string text;
  double x;
};

// The texts of a picture in SVG, those without a letter left out. gnuplot writes each in a line.
inline std::vector<PlacedText> texts_of(const std::string &path) {
  const std::regex place("translate\\(([-0-9.]+),"), tag("<[^>]*>");
  std::vector<PlacedText> texts;
  std::ifstream file = truth::opened(path);
  double x = 0.0;
  std::smatch found;
  for (std::string line; std::getline(file, line);) {
    if (std::regex_search(line, found, place)) x = std::stod(found[1]);
    if (line.find("<text") == std::string::npos) continue;
    std::string text = std::regex_replace(line, tag, "");
    text.erase(0, text.find_first_not_of(" \t"));
    if (!text.empty()) texts.push_back({text, x});
  }
  return texts;
}

// The drawing that the script of a figure makes from the tables in a folder.
inline std::vector<Panel> drawn_from(const std::string &folder, const std::string &figure) {
  for (const char *kind : {"table", "svg"})
    run("cd " SOURCE_DIR " && gnuplot -e \"data='" + folder + "'; kind='" + kind + "'\" figures/" +
        figure + ".gp");
  std::vector<Panel> panels = panels_in_table(folder + "/" + figure + ".table");
  add_picture(panels, folder + "/" + figure + ".svg");
  return panels;
}

// The same, from the tables that the driver of the figure writes to the folder first.
inline std::vector<Panel> drawn(const std::string &figure, const std::string &folder) {
  run(std::string(PROGRAM_DIR "/") + figure + " --output " + folder + " 2>/dev/null");
  return drawn_from(folder, figure);
}

// The colour of a line type of style.gp, as SVG has it.
inline std::string colour_of_line_type(int type) {
  const std::string rule = "set linetype " + std::to_string(type) + " linecolor rgb '#";
  std::ifstream file = truth::opened(SOURCE_DIR "/figures/style.gp");
  for (std::string line; std::getline(file, line);) {
    if (!line.starts_with(rule)) continue;
    const int rgb = std::stoi(line.substr(rule.size(), 6), nullptr, 16);
    return fmt::format("rgb({:3}, {:3}, {:3})", rgb >> 16, (rgb >> 8) & 255, rgb & 255);
  }
  throw std::runtime_error(rule + "...: style.gp has no such line");
}

}  // namespace vibro_impact::testing
