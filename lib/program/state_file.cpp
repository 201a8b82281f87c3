#include "state_file.hpp"

#include <boost/crc.hpp>
#include <iterator>
#include <sstream>

#include "refuse.hpp"
#include "scene_options.hpp"

namespace vibro_impact::runner {

namespace {

constexpr std::string_view kind = "vibro-impact state 6, checksum ";

std::string rest_of(std::istream &file) {
  return std::string(std::istreambuf_iterator<char>(file), {});
}

}  // namespace

std::string first_line(std::string_view others) {
  boost::crc_32_type checksum;
  checksum.process_bytes(others.data(), others.size());
  return fmt::format("{}{:08x}\n", kind, checksum.checksum());
}

std::string text_of(const SavedRun &run) {
  const std::string others =
      fmt::format("{}\ntime {:.17g}\n{}", run.scene_text, run.time, save(run.state));
  return first_line(others) + others;
}

SavedRun read_saved_run(std::istream &file, const std::string &name) {
  try {
    std::string start(first_line("").size(), '\0'), word;
    file.read(start.data(), static_cast<std::streamsize>(start.size()));
    // A device without an end is not read to its end.
    if (!start.starts_with(kind)) refuse("cannot be read, or does not begin with '{}'", kind);
    const std::string others = rest_of(file);
    if (start != first_line(others))
      refuse("the checksum does not fit: the file was cut short or changed");
    std::istringstream lines(others);
    SavedRun run;
    std::getline(lines, run.scene_text);
    run.scene = scene_in(run.scene_text);
    if (!(lines >> word >> run.time) || word != "time" || lines.get() != '\n')
      refuse("'time' expected behind the scene");
    run.state = load(run.scene, rest_of(lines));
    return run;
  } catch (const std::invalid_argument &error) {
    refuse("{}: {}", name, error.what());
  }
}

}  // namespace vibro_impact::runner
