#include "drawn.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <fstream>
#include <regex>
#include <sstream>
#include <stdexcept>

#include "reference/truth/table_reader.hpp"

namespace vibro_impact::testing {

void run(const std::string &command) {
  if (std::system(command.c_str()) != 0) throw std::runtime_error(command + ": failed");
}

Columns columns_of(const std::string &path) {
  const truth::Row names = truth::header_of(path);
  Columns columns;
  for (const auto &cells : truth::read_rows(path, names.size()))
    for (std::size_t i = 0; i < names.size(); ++i)
      if (const auto value = truth::as_number(cells[i])) columns[names[i]].push_back(*value);
  return columns;
}

namespace {

// The curves as gnuplot's `set table` writes them: x, y, ... and `u` at the end for no point.
std::vector<Panel> panels_in_table(const std::string &path) {
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

// The text in a line of SVG, without its fonts. It is empty if the line has none.
std::string text_in(const std::string &line) {
  static const std::regex tag("<[^>]*>");
  if (line.find("<text") == std::string::npos) return "";
  std::string text = std::regex_replace(line, tag, "");
  text.erase(0, text.find_first_not_of(" \t"));
  return text;
}

// Adds what the picture tells. Its group gnuplot_plot_2b is the second curve of the second panel
// (an opaque key draws them twice); tick labels and letter of a panel come before its first curve.
void add_picture(std::vector<Panel> &panels, const std::string &path) {
  const std::regex plot("id=\"gnuplot_plot_([0-9]+)([a-z])"),
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
    } else if (const std::string text = text_in(line); !text.empty()) {
      texts.push_back(text);
    } else if (curve != nullptr && curve->colour.empty() &&
               std::regex_search(line, found, colour)) {
      curve->colour = found[1];
    }
  }
}

}  // namespace

std::multimap<std::string, double> texts_of(const std::string &path) {
  const std::regex place("translate\\(([-0-9.]+),");
  std::multimap<std::string, double> texts;
  std::ifstream file = truth::opened(path);
  double x = 0.0;
  std::smatch found;
  for (std::string line; std::getline(file, line);) {
    if (std::regex_search(line, found, place)) x = std::stod(found[1]);
    if (const std::string text = text_in(line); !text.empty()) texts.emplace(text, x);
  }
  return texts;
}

std::vector<Panel> drawn(const std::string &figure, const std::string &folder) {
  run(std::string(PROGRAM_DIR "/") + figure + " --output " + folder + " 2>/dev/null");
  for (const char *kind : {"table", "svg"})
    run("cd " SOURCE_DIR " && gnuplot -e \"data='" + folder + "'; kind='" + kind + "'\" figures/" +
        figure + ".gp");
  std::vector<Panel> panels = panels_in_table(folder + "/" + figure + ".table");
  add_picture(panels, folder + "/" + figure + ".svg");
  return panels;
}

std::string colour_of_line_type(int type) {
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
