// The options of a scene, which `run` and `sweep` share, and what their words stand for.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "vibro_impact/analysis/sweep.hpp"

namespace vibro_impact::runner {

// The words of the command line as they were given, with the defaults of the paper's Figure 2.
struct SceneOptions {
  int masses = 2;
  std::string mass = "1", stiffness = "1", beta = "0.1", restitution = "0.7", amplitude = {};
  std::string omega = "0.2797", displacement = "0", velocity = "0";
  std::vector<std::string> stops = {};
};

// An option that takes one value.
template <class Value>
CLI::Option *option(CLI::App &app, const char *name, Value &value, const char *type,
                    const char *what) {
  CLI::Option *added = app.add_option(name, value, what)->type_name(type)->capture_default_str();
  if constexpr (std::is_same_v<Value, double>) added->check(CLI::Number);
  return added->check([](const std::string &word) { return word.empty() ? "needs a value" : ""; });
}

void add_scene_options(CLI::App &app, SceneOptions &options);

// These throw std::invalid_argument with one line that names what was given; `scene_of` also that
// of `check` for a scene that makes no sense.
Scene scene_of(const SceneOptions &options);
Axis axis_of(const std::string &text);  // parameter=from:to:count

// The options given on which a motion depends (those that are configurable, as CLI11 has it), as
// words --name=value in one line; and the scene that such words stand for.
std::string given(const CLI::App &app);
Scene scene_in(const std::string &text);

}  // namespace vibro_impact::runner
