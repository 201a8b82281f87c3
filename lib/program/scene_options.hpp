// The options of a scene, which `run` and `sweep` share, and the numbers of all options.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <type_traits>
#include <vector>

#include "vibro_impact/scene.hpp"

namespace vibro_impact::runner {

// A table that was written with --header begins with this, and is a file of its scene.
inline constexpr const char *table_head = "# vibro-impact ";

// The options of a scene as they were given. The defaults are the scene of the paper's Figure 2,
// and stand nowhere else in the program; a test compares them with the scenes of the paper.
struct SceneOptions {
  int masses = 2;
  double beta = 0.1, restitution = 0.7, omega = 0.2;
  std::string mass = "1", stiffness = "1", displacement = "0", velocity = "0";
  std::string amplitude = {};  // empty: 0.5 on mass 1, however many masses there are
  std::string sine = "0", constant = "0", ground = "0", file = {};
  bool print = false;
  std::vector<std::string> stops = {};  // empty: those of the paper on masses that the chain has
};

// The parts of `text` between separators. Parts may be empty.
std::vector<std::string> split(const std::string &text, char separator);

// The number that a whole word of `given` stands for. All numbers of the command line and of scene
// files are read by it. Refuses what is none.
double number(const std::string &given, const std::string &word);

// The same of a whole number from 1 to `most`.
long long whole_number(const std::string &given, const std::string &word, double most);

// The beginning of a text that was given, for a message: printable, and short.
std::string shown(const std::string &text);

// An option that takes one value.
template <class Value>
CLI::Option *option(CLI::App &app, const std::string &name, Value &value, const char *type,
                    const std::string &what) {
  CLI::Option *added = app.add_option(name, value, what)->type_name(type)->capture_default_str();
  return added->check([name](const std::string &word) {
    if constexpr (std::is_same_v<Value, double>) number(name + " " + shown(word), word);
    return word.empty() ? "needs a value" : "";
  });
}

// An option that takes a whole number from 1 to `most`, in any notation.
template <class Value>
CLI::Option *count_option(CLI::App &app, const std::string &name, Value &value, double most,
                          const std::string &what) {
  CLI::Option *added = app.add_option(name, value, what)->type_name("N")->capture_default_str();
  return added->transform(CLI::Validator(
      [name, most](std::string &word) {
        word = std::to_string(whole_number(name + " " + shown(word), word, most));
        return std::string();
      },
      ""));
}

void add_scene_options(CLI::App &app, SceneOptions &words);

// The scene that the options describe. Refuses what `check` refuses.
Scene scene_of(const SceneOptions &words);

// The arguments, and before them those of the scene in the file of --scene, where they do not give
// them anew. In the order in which CLI11 takes them: the last first. `command` has the options of a
// scene. A file of a scene has lines `name = value` of these options, empty lines and comments. A
// table that begins with such lines behind `# ` is a file of its scene. Refuses any other file with
// its name, the number of the line and the rule.
std::vector<std::string> reversed_arguments(int argc, const char *const *argv,
                                            const CLI::App &command);

// The options of a scene as a file that --scene reads.
std::string scene_file(const CLI::App &app, const SceneOptions &words);

}  // namespace vibro_impact::runner
