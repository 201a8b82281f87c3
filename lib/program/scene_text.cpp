#include "scene_text.hpp"

#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "files.hpp"

namespace vibro_impact::runner {

std::vector<std::string> split(const std::string &text, char separator) {
  return CLI::detail::split(text + separator, separator);
}

double number(const std::string &given, const std::string &word) {
  try {
    return detail::number_of(word);
  } catch (const std::invalid_argument &error) {
    refuse("{}: {}", given, error.what());
  }
}

long long whole_number(const std::string &given, const std::string &word, double most) {
  const double value = number(given, word);
  if (!(value >= 1.0 && value <= most && value == std::floor(value)))
    refuse("{}: '{}' must be a whole number from 1 to {}", given, shown(word), most);
  return static_cast<long long>(value);
}

namespace {

// Longer chains are taken for a slip of the pen. The eigenvectors of a chain take cubic work, and
// those of 2,000 masses ten seconds.
constexpr double most_masses = 2000;

// Gives the field of this name its value. A list of zeros becomes empty, so that the forces that a
// scene does not have cost nothing.
void set(Scene &scene, const SceneLine &line) {
  try {
    set_field(scene, line.name, fmt::format("{}", fmt::join(line.words, ",")));
  } catch (const std::invalid_argument &error) {
    refuse("{}: {}", line.given, error.what());
  }
  for (const auto &field : list_fields)
    if (std::vector<double> &values = scene.*field.value;
        line.name == field.name && field.optional &&
        std::ranges::count(values, 0.0) == std::ssize(values))
      values.clear();
}

// The words of a value in a file: a word, or words separated by commas, which may stand in brackets
// and in quotes. Returns no words if a bracket or a quote has no partner.
std::vector<std::string> words_in(std::string value) {
  if (value.starts_with('[') && value.ends_with(']')) value = value.substr(1, value.size() - 2);
  if (value.find_first_of("[]") != std::string::npos) return {};
  for (const char quote : {'"', '\''}) {
    if (std::count(value.begin(), value.end(), quote) % 2 != 0) return {};
    std::erase(value, quote);
  }
  std::vector<std::string> words = split(value, ',');
  for (std::string &word : words) CLI::detail::trim(word);
  return words;
}

}  // namespace

std::vector<SceneLine> scene_lines(const std::string &path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) refuse("--scene {}: is no file", path);
  std::ifstream file(path, std::ios::binary);
  if (!file) refuse("--scene {}: cannot be read", path);
  const auto known = words_of(default_scene(1));
  const auto has = [](const auto &range, const std::string &name, auto member) {
    return std::ranges::find(range, name, member) != range.end();
  };
  std::vector<SceneLine> lines;
  bool in_table = false;
  std::size_t number = 0;
  for (std::string line; std::getline(file, line);) {
    if (++number == 1 && line.starts_with("\xEF\xBB\xBF")) line.erase(0, 3);
    if (number == 1) in_table = line.starts_with(table_head);
    if (in_table && !line.starts_with('#')) break;
    if (in_table) line.erase(0, number == 1 ? line.size() : 1);
    line.erase(std::min(line.size(), line.find('#')));
    CLI::detail::trim(line);
    if (line.empty()) continue;
    const std::string given = fmt::format("--scene {}, line {}: {}", path, number, shown(line));
    const std::size_t equals = line.find('=');
    if (equals == std::string::npos) refuse("{}: must read name = value", given);
    const std::string name = CLI::detail::trim_copy(line.substr(0, equals));
    if (!has(known, name, &std::pair<std::string, std::string>::first))
      refuse("{}: is no option of a scene", given);
    if (has(lines, name, &SceneLine::name)) refuse("{}: is given twice", given);
    lines.push_back({name, given, words_in(CLI::detail::trim_copy(line.substr(equals + 1)))});
    if (lines.back().words.empty()) refuse("{}: a bracket or a quote is not closed", given);
  }
  if (file.bad()) refuse("--scene {}: cannot be read", path);
  return lines;
}

Scene default_scene(int masses) {
  const auto size = static_cast<std::size_t>(masses);
  Scene scene{.mass = std::vector<double>(size, 1.0),
              .stiffness = std::vector<double>(size, 1.0),
              .beta = 0.1,
              .amplitude = std::vector<double>(size, 0.0),
              .omega = 0.2,
              .restitution = 0.7,
              .stops = {{1, Side::lower, -0.3}, {2, Side::upper, 0.1}}};
  scene.amplitude.front() = 0.5;
  if (masses < 2) scene.stops.pop_back();
  return scene;
}

Scene scene_of(const std::vector<SceneLine> &lines) {
  const auto masses = std::ranges::find(lines, "masses", &SceneLine::name);
  Scene scene = default_scene(2);
  if (masses != lines.end())
    scene = default_scene(static_cast<int>(whole_number(
        masses->given, fmt::format("{}", fmt::join(masses->words, ",")), most_masses)));
  for (const SceneLine &line : lines)
    if (line.name != "masses") set(scene, line);
  check(scene);
  return scene;
}

std::vector<std::pair<std::string, std::string>> words_of(const Scene &scene) {
  std::vector<std::pair<std::string, std::string>> words;
  words.emplace_back("masses", std::to_string(scene.masses()));
  for (const auto &field : list_fields) {
    std::vector<double> values = scene.*field.value;
    if (values.empty()) values = {0.0};
    if (std::ranges::count(values, values.front()) == std::ssize(values)) values.resize(1);
    words.emplace_back(field.name, fmt::format("{}", fmt::join(values, ",")));
  }
  for (const auto &field : scalar_fields)
    words.emplace_back(field.name, fmt::format("{}", scene.*field.value));
  words.emplace_back("stop", detail::joined(scene.stops, "none"));
  return words;
}

}  // namespace vibro_impact::runner
