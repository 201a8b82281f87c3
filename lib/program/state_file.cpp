#include "state_file.hpp"

#include <fstream>
#include <iterator>
#include <sstream>

#include "refuse.hpp"
#include "scene_options.hpp"
#include "vibro_impact/checksum.hpp"

namespace vibro_impact::runner {

namespace {

constexpr std::string_view kind = "vibro-impact state ", version = "5";

std::string rest_of(std::istream &file) {
  return std::string(std::istreambuf_iterator<char>(file), {});
}

// What stands below the first line, which fits. A device without an end is not read to its end.
std::string checked(std::istream &file) {
  std::string start(kind.size() + version.size(), '\0'), end_of_line;
  file.read(start.data(), static_cast<std::streamsize>(start.size()));
  if (!file || !start.starts_with(kind)) refuse("is not a state file");
  if (!start.ends_with(version))
    refuse(
        "a state file of version {}, not {}: the version of vibro-impact that wrote it goes on "
        "with it",
        start.substr(kind.size()), version);
  std::getline(file, end_of_line);
  const std::string others = rest_of(file);
  if (start + end_of_line + "\n" != first_line(others))
    refuse("the checksum does not fit: the file was cut short or changed");
  return others;
}

}  // namespace

std::string first_line(std::string_view others) {
  Checksum checksum;
  checksum.add(others);
  return fmt::format("{}{}, checksum {}\n", kind, version, checksum.text());
}

std::optional<std::string> text_of(const SavedRun &run) {
  std::string text = fmt::format("{}time {:.17g}\n{}", run.scene_text, run.time, save(run.state));
  text = first_line(text) + text;
  try {
    std::istringstream file(text);
    read_saved_run(file, "");
  } catch (const std::invalid_argument &) {
    return std::nullopt;
  }
  return text;
}

SavedRun read_saved_run(std::istream &file, const std::string &name) {
  try {
    std::istringstream lines(checked(file));
    SavedRun run;
    std::string line;
    while (std::getline(lines, line) && line.starts_with("--")) run.scene_text += line + "\n";
    run.scene = scene_in(run.scene_text);
    std::istringstream words(line);
    std::string word;
    if (!(words >> word >> run.time) || word != "time") refuse("'time' expected behind the scene");
    run.state = load(run.scene, rest_of(lines));
    return run;
  } catch (const std::invalid_argument &error) {
    refuse("{}: {}", name, error.what());
  }
}

SavedRun read_saved_run(const std::string &path) {
  const std::string name = fmt::format("--resume {}", path);
  std::ifstream file(path, std::ios::binary);
  if (!file) refuse("{}: cannot be read", name);
  return read_saved_run(file, name);
}

}  // namespace vibro_impact::runner
