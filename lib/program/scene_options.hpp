// The options of a scene, which `run` and `sweep` share.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "vibro_impact/scene.hpp"

namespace vibro_impact::runner {

// The words of the command line as they were given, with the defaults of the paper's Figure 2, and
// the options that took them: of some the absence, too, means something.
struct SceneOptions {
  std::string masses = "2", mass = "1", stiffness = "1", damping = "0.1", beta, restitution = "0.7";
  std::string amplitude = "0.5,0", omega = "0.2797", displacement = "0", velocity = "0";
  std::vector<std::string> stops = {"1:lower:-0.3", "2:upper:0.1"};

  std::vector<const CLI::Option *> all = {};
};

// An option that takes one value.
template <class Value>
CLI::Option *option(CLI::App &app, const char *name, Value &value, const char *type,
                    const char *what) {
  return app.add_option(name, value, what)->type_name(type)->capture_default_str();
}

void add_scene_options(CLI::App &app, SceneOptions &options);

// Throws std::invalid_argument with one line, that of `check` for a scene that makes no sense.
Scene scene_of(const SceneOptions &options);

// The options that were given, one a line as --name=value, and the scene they stand for.
std::string text_of(const SceneOptions &options);
Scene scene_in(const std::string &text);

}  // namespace vibro_impact::runner
