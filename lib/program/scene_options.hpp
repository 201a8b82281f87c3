// The options of a scene, which `run` and `sweep` share.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <type_traits>
#include <vector>

#include "vibro_impact/scene.hpp"

namespace vibro_impact::runner {

// The options of a scene, which `run` and `sweep` share, as they were given. The defaults are the
// scene of the paper's Figure 2, and stand nowhere else in the program; a test compares them with
// the scenes of the paper.
struct SceneOptions {
  int masses = 2;
  double beta = 0.1, restitution = 0.7, omega = 0.2;
  std::string mass = "1", stiffness = "1", displacement = "0", velocity = "0";
  std::string amplitude = {};  // empty: 0.5 on mass 1, however many masses there are
  std::string sine = "0", constant = "0", ground = "0", file = {};
  bool print = false;
  std::vector<std::string> stops = {"1:lower:-0.3", "2:upper:0.1"};
};

// An option that takes one value.
template <class Value>
CLI::Option *option(CLI::App &app, const char *name, Value &value, const char *type,
                    const std::string &what) {
  CLI::Option *added = app.add_option(name, value, what)->type_name(type)->capture_default_str();
  if constexpr (std::is_same_v<Value, double>) added->check(CLI::Number);
  return added->check([](const std::string &word) { return word.empty() ? "needs a value" : ""; });
}

// The parts of `text` between separators. Parts may be empty.
std::vector<std::string> split(const std::string &text, char separator);

// The number that a whole word of `given` stands for. Refuses what is none.
double number(const std::string &given, const std::string &word);

// The same of a whole number from 1 to `most`.
int whole_number(const std::string &given, const std::string &word, double most);

void add_scene_options(CLI::App &app, SceneOptions &words);

// The scene that the options describe. Refuses what `check` refuses.
Scene scene_of(const SceneOptions &words);

// The arguments, and before them those of the scene in the file of --scene, where they do not give
// them anew. In the order in which CLI11 takes them: the last first.
std::vector<std::string> reversed_arguments(int argc, const char *const *argv);

// The options of a scene as a file that --scene reads.
std::string scene_file(const CLI::App &app, const SceneOptions &words);

}  // namespace vibro_impact::runner
