#include "state_file.hpp"

#include <fstream>
#include <iterator>
#include <sstream>

#include "refuse.hpp"
#include "scene_options.hpp"
#include "values.hpp"
#include "vibro_impact/checksum.hpp"

namespace vibro_impact::runner {

namespace {

constexpr std::string_view kind = "vibro-impact state ", version = "4\n";

// The text before the checksum, which fits.
std::string checked(std::istream &file) {
  std::string start(kind.size() + version.size(), '\0');
  file.read(start.data(), static_cast<std::streamsize>(start.size()));
  if (!file || !start.starts_with(kind)) refuse("is not a state file");
  if (!start.ends_with(version))
    refuse(
        "a state file of version {}, not {}: the version of vibro-impact that wrote it goes on "
        "with it",
        start.substr(kind.size(), 1), version.substr(0, 1));
  std::string text = start + std::string(std::istreambuf_iterator<char>(file), {});
  const std::size_t end = text.rfind("checksum ");
  if (end == std::string::npos || !text.ends_with('\n')) refuse("the file is cut short");
  if (text.substr(end) != checksum_line(text.substr(0, end)))
    refuse("the checksum does not fit: the file was changed");
  return text.substr(start.size(), end - start.size());
}

}  // namespace

std::optional<std::string> text_of(const SavedRun &run) {
  std::string text = fmt::format("{}{}{}time {:.17g}\n{}", kind, version, run.scene_text, run.time,
                                 save(run.state));
  text += checksum_line(text);
  try {
    std::istringstream file(text);
    read_saved_run(file, "");
  } catch (const std::invalid_argument &) {
    return std::nullopt;
  }
  return text;
}

std::string checksum_line(std::string_view text) {
  Checksum checksum;
  checksum.add(text);
  return fmt::format("checksum {}\n", checksum.text());
}

SavedRun read_saved_run(std::istream &file, const std::string &name) {
  try {
    std::istringstream lines(checked(file));
    SavedRun run;
    std::string line;
    while (std::getline(lines, line) && line.starts_with("--")) run.scene_text += line + "\n";
    run.scene = scene_in(run.scene_text);
    if (!line.starts_with("time ")) refuse("'time' expected behind the scene");
    run.time = number("time", line.substr(5));
    run.state = load(run.scene, std::string(std::istreambuf_iterator<char>(lines), {}));
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
