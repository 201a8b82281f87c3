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

  std::vector<const CLI::Option *> all = {};  // that took them
};

// An option that takes one value.
template <class Value>
CLI::Option *option(CLI::App &app, const char *name, Value &value, const char *type,
                    const char *what) {
  return app.add_option(name, value, what)
      ->type_name(type)
      ->capture_default_str()
      ->check([](const std::string &word) { return word.empty() ? "needs a value" : ""; });
}

void add_scene_options(CLI::App &app, SceneOptions &options);

// These throw std::invalid_argument with one line that names what was given; `scene_of` also that
// of `check` for a scene that makes no sense.
Scene scene_of(const SceneOptions &options);
Axis axis_of(const std::string &text);  // parameter=from:to:count

// The options that were given, one a line as --name=value, and the scene they stand for.
std::string text_of(const SceneOptions &options);
Scene scene_in(const std::string &text);

}  // namespace vibro_impact::runner
