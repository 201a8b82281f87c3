#include "scene_text.hpp"

#include <fmt/ranges.h>

#include <CLI/StringTools.hpp>
#include <algorithm>
#include <filesystem>
#include <fstream>

namespace vibro_impact::runner {

namespace {

// Longer chains are taken for a slip of the pen. The eigenvectors of a chain take cubic work, and
// those of 2,000 masses ten seconds.
constexpr long long most_masses = 2000;

// Gives a scene the value of a line. A list of zeros becomes empty: rounding differs with springs
// of stiffness zero, and a scene that was written has the motion of the scene itself to the bit.
void set(Scene &scene, const SceneLine &line) {
  const bool known = read_at(line.given, [&] { return set_field(scene, line.name, line.words); });
  if (!known) refuse("{}: is no option of a scene", line.given);
  for (const auto &field : list_fields)
    if (std::vector<double> &values = scene.*field.value;
        field.optional && std::ranges::count(values, 0.0) == std::ssize(values))
      values.clear();
}

// A value of a file in the words of set_field. The value may stand in brackets and its words in
// quotes, and there may be blanks beside a comma.
std::string words_in(std::string value) {
  if (value.starts_with('[') && value.ends_with(']')) value = value.substr(1, value.size() - 2);
  bool closed = value.find_first_of("[]") == std::string::npos;
  for (const char quote : {'"', '\''}) closed = std::erase(value, quote) % 2 == 0 && closed;
  if (!closed) throw std::invalid_argument("a bracket or a quote is not closed");
  std::vector<std::string> words;
  for (const std::string_view word : parts_of(value, ','))
    words.push_back(CLI::detail::trim_copy(std::string(word)));
  return fmt::format("{}", fmt::join(words, ","));
}

}  // namespace

std::vector<SceneLine> scene_lines(const std::string &path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) refuse("--scene {}: is no file", path);
  std::ifstream file(path, std::ios::binary);
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
    const std::string name = CLI::detail::trim_copy(line.substr(0, equals)),
                      value = CLI::detail::trim_copy(line.substr(equals + 1));
    if (std::ranges::find(lines, name, &SceneLine::name) != lines.end())
      refuse("{}: is given twice", given);
    lines.push_back({name, given, read_at(given, [&] { return words_in(value); })});
  }
  if (file.bad() || !file.is_open()) refuse("--scene {}: cannot be read", path);
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
  Scene scene = default_scene(2);
  for (const SceneLine &line : lines)
    if (line.name == "masses")
      scene = default_scene(
          static_cast<int>(read_at(line.given, [&] { return count_of(line.words, most_masses); })));
  for (const SceneLine &line : lines)
    if (line.name != "masses") set(scene, line);
  check(scene);
  return scene;
}

std::vector<FieldInWords> words_of(const Scene &scene) {
  std::vector<FieldInWords> fields = fields_in_words(scene);
  for (FieldInWords &field : fields)
    if (field.words.empty()) field.words = "0";
  return fields;
}

}  // namespace vibro_impact::runner
