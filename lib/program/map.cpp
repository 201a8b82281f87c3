#include "map.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <functional>
#include <utility>

namespace vibro_impact::runner {

namespace {

constexpr std::size_t colours = 12;  // of numbers, in plot.gp

}  // namespace

std::string map_word(const Column &column, const PointRecord &result) {
  if (!result.record) return column.continuous ? "=nan" : result.refused ? "refused" : "given up";
  Table cell;
  column.add_cell(cell, *result.record);
  cell.text.pop_back();  // the comma
  if (column.continuous) return "=" + cell.text;
  const bool is_of_period = column.name == "period" || column.name == "attractor";
  if (is_of_period && result.record->period == 0)
    return result.record->approached > 0 ? "none found" : "irregular";
  return fmt::format("{:.6g}", std::stod(cell.text));
}

void Map::add(const std::vector<double> &parameters, const std::string &word) {
  const bool is_value = word[0] == '=';
  if (!is_value) ++points_[word];
  file_.append(
      fmt::format("{},{},{}\n", parameters[0], parameters[1], word.substr(is_value ? 1 : 0)));
}

std::string Map::classes() const {
  std::vector<std::pair<std::size_t, double>> numbers;  // behind the number of their points
  std::vector<std::string> classes;
  for (const auto &[word, points] : points_)
    if (word.find_first_of("0123456789") != std::string::npos)
      numbers.emplace_back(points, std::stod(word));
    else
      classes.push_back("'" + word + "'");
  std::ranges::sort(numbers, std::greater());
  if (numbers.size() > colours) {
    numbers.resize(colours);
    classes.insert(classes.begin(), "other");
  }
  std::ranges::sort(numbers, std::greater(), [](const auto &number) { return number.second; });
  for (const auto &[points, number] : numbers)
    classes.insert(classes.begin(), fmt::format("{:.6g}", number));
  return fmt::format("{}", fmt::join(classes, " "));
}

}  // namespace vibro_impact::runner
