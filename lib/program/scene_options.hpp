// The options of a scene, which `run` and `sweep` share, and the scene that they describe.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "vibro_impact/analysis/sweep.hpp"

namespace vibro_impact::runner {

// The words of the command line as they were given. The defaults are the scene of the paper's
// Figure 2, and stand nowhere else in the program; a test compares them with the scenes of the
// paper.
struct SceneOptions {
  int masses = 2;
  double beta = 0.1, restitution = 0.7, omega = 0.2797;
  std::string mass = "1", stiffness = "1", displacement = "0", velocity = "0";
  std::string amplitude = {};  // empty: 0.5 on mass 1, however many masses there are
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

void add_scene_options(CLI::App &app, SceneOptions &options);

// Both throw std::invalid_argument with one line that names what was given. `scene_of` throws what
// `check` throws for a scene that makes no sense, too.
Scene scene_of(const SceneOptions &options);
Axis axis_of(const std::string &text);  // parameter=from:to:count

// The options of a sweep that were given and on which its rows depend (those that are configurable,
// as CLI11 has it), as words --name=value in one line.
std::string given(const CLI::App &app);

}  // namespace vibro_impact::runner
