// The scenes of tests/scenes: files of the program, with comments that say why a scene is there.
// `vibro-impact run --scene FILE` with the options of each line `# run` comes to its end, and has
// what the lines `# expect` say. Other comments stand before the settings. The lines compare a
// quantity with a number or another quantity:
//   impacts, sticks, releases, expansions   counters of the run
//   events, jumps   events that are listed, and releases by a jump of the force
//   x1, x2, ...     displacements at the end
//   impact, stick 2, last release 1   time of the first or last such event, of any or one mass
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <sstream>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "program/options.hpp"
#include "vibro_impact/scene_text.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace {

using namespace vibro_impact;

using Quantities = std::map<std::string, double>;

Quantities quantities_of(const runner::RunRequest &request) {
  EventRecorder recorder;
  const Outcome outcome =
      require_complete(simulate(request.scene, request.until, request.options, recorder));
  Quantities found;
  for (const auto &[name, count] : {std::pair{"impacts", outcome.counters.impacts},
                                    {"sticks", outcome.counters.sticks},
                                    {"releases", outcome.counters.releases},
                                    {"expansions", outcome.counters.expansions}})
    found[name] = static_cast<double>(count);
  for (std::size_t i = 0; i < outcome.state.displacement.size(); ++i)
    found["x" + std::to_string(i + 1)] = outcome.state.displacement[i];
  found["events"] = static_cast<double>(recorder.events.size());
  for (const Event &event : recorder.events) {
    found["jumps"] += event.by_a_jump ? 1.0 : 0.0;
    const std::string kind = name(event.kind), of_mass = kind + " " + std::to_string(event.mass);
    for (const std::string &words : {kind, of_mass}) {
      found.emplace(words, event.time);
      found["last " + words] = event.time;
    }
  }
  return found;
}

// The line reads `quantity = value`, `quantity = value +- tolerance`, or has < or > instead.
void expect(const std::string &line, const Quantities &found) {
  static const std::regex form("(.+) ([=<>]) (.+?)( \\+- (.+))?");
  std::smatch part;
  ASSERT_TRUE(std::regex_match(line, part, form)) << line;
  ASSERT_TRUE(found.contains(part[1])) << line;
  const auto number_of = [&](const std::string &word) {
    return found.contains(word) ? found.at(word) : words::number_of(word);
  };
  const double quantity = number_of(part[1]), value = number_of(part[3]),
               tolerance = part[4].matched ? number_of(part[5]) : 0.0;
  EXPECT_TRUE((part[2] == "<" && quantity < value) || (part[2] == ">" && quantity > value) ||
              (part[2] == "=" && std::abs(quantity - value) <= tolerance))
      << line << ": is " << words::words_of(quantity);
}

// The rest of each line of a file that begins with `mark`, after the first setting.
std::vector<std::string> marked_lines(const std::string &path, const std::string &mark) {
  std::ifstream file(path);
  std::vector<std::string> lines;
  bool is_set = false;
  for (std::string line; std::getline(file, line);) {
    is_set = is_set || !line.starts_with("#");
    if (is_set && line.starts_with(mark)) lines.push_back(line.substr(mark.size()));
  }
  return lines;
}

std::vector<std::string> scene_files() {
  std::vector<std::string> names;
  for (const auto &file : std::filesystem::directory_iterator(SOURCE_DIR "/tests/scenes"))
    names.push_back(file.path().stem().string());
  return names;
}

class Scenes : public ::testing::TestWithParam<std::string> {};

TEST_P(Scenes, HaveWhatTheirFilesExpect) {
  const std::string path = SOURCE_DIR "/tests/scenes/" + GetParam() + ".scene";
  const std::vector<std::string> runs = marked_lines(path, "# run "),
                                 expected = marked_lines(path, "# expect ");
  EXPECT_FALSE(runs.empty());
  EXPECT_EQ(marked_lines(path, "#").size(), runs.size() + expected.size()) << "an unknown mark";
  for (const std::string &options : runs) {
    SCOPED_TRACE("vibro-impact run --scene " + path + " " + options);
    std::vector<const char *> arguments{"vibro-impact", "run", "--scene", path.c_str()};
    std::istringstream text(options);
    const std::vector<std::string> words(std::istream_iterator<std::string>(text), {});
    for (const std::string &word : words) arguments.push_back(word.c_str());
    const runner::Request request =
        runner::parse(static_cast<int>(arguments.size()), arguments.data());
    const Quantities found = quantities_of(std::get<runner::RunRequest>(request));
    for (const std::string &line : expected) expect(line, found);
  }
}

INSTANTIATE_TEST_SUITE_P(Files, Scenes, ::testing::ValuesIn(scene_files()),
                         [](const auto &file) { return file.param; });

}  // namespace
