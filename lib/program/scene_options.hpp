// The options of a scene, which `run` and `sweep` share.
#pragma once

#include <string>
#include <vector>

#include "vibro_impact/scene.hpp"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace vibro_impact::runner {

// The words of the command line as they were given, with the defaults of the paper's Figure 2.
struct SceneWords {
  std::string masses = "2", mass = "1", stiffness = "1", damping = "0.1", beta, restitution = "0.7";
  std::string amplitude = "0.5,0", omega = "0.2797", displacement = "0", velocity = "0";
  std::vector<std::string> stops = {"1:lower:-0.3", "2:upper:0.1"};
};

// The options themselves: those of which the absence, too, means something by name.
struct SceneOptions {
  std::vector<const CLI::Option *> all = {};
  const CLI::Option *amplitude = nullptr, *beta = nullptr, *stops = nullptr;
};

// An option that takes the word `value`.
CLI::Option *option(CLI::App &app, const char *name, std::string &value, const char *type,
                    const char *what);

SceneOptions add_scene_options(CLI::App &app, SceneWords &words);

// Throws BadInput, or std::invalid_argument from `check` for a scene that makes no sense.
Scene scene_of(const SceneWords &words, const SceneOptions &given);

}  // namespace vibro_impact::runner
