// Scenes in words, as options and as lines `name = value` of a file, and the numbers of all
// options.
#pragma once

#include <string>
#include <vector>

#include "vibro_impact/scene_text.hpp"

namespace vibro_impact::runner {

// A table that was written with --header begins with this, and is a file of its scene.
inline constexpr const char *table_head = "# vibro-impact ";

// The parts of `text` between separators. Parts may be empty.
std::vector<std::string> split(const std::string &text, char separator);

using detail::shown;

// The number that a whole word of `given` stands for. All numbers of the command line and of scene
// files are read by it. Refuses what is none.
double number(const std::string &given, const std::string &word);

// The same of a whole number from 1 to `most`.
long long whole_number(const std::string &given, const std::string &word, double most);

// The value of a field of a scene, of `masses` or of `stop`, in words. Messages begin with `given`.
struct SceneLine {
  std::string name, given;
  std::vector<std::string> words;
};

// The lines of a file: lines `name = value`, empty lines and comments. A table that begins with
// such lines behind `# ` is a file of its scene. Refuses any other file with its name, the number
// of the line and the rule.
std::vector<SceneLine> scene_lines(const std::string &path);

// The scene of the paper's Figure 2 for two masses; a chain of another length has its forcing on
// mass 1 and those of its stops whose masses exist. These are the defaults of the program; a test
// compares them with the scenes of the paper.
Scene default_scene(int masses);

// The default scene with the values of these lines. Refuses what `check` refuses, too.
Scene scene_of(const std::vector<SceneLine> &lines);

// The names and values of a scene in words, in the order of a file. One value stands for equal
// ones.
std::vector<std::pair<std::string, std::string>> words_of(const Scene &scene);

}  // namespace vibro_impact::runner
