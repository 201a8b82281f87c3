// The scene of a command: the lines of its file and its options, in words.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "files.hpp"
#include "vibro_impact/scene_text.hpp"

namespace vibro_impact::runner {

using words::count_of, words::number_of, words::parts_of, words::refuse_words, words::shown;

// A table that was written with --header begins with this, and is a file of its scene.
inline constexpr const char *table_head = "# vibro-impact ";

// The result of `read`. The message of its refusal begins with `given`, the place of the words that
// it reads.
template <class Read>
auto read_at(const std::string &given, const Read &read) {
  try {
    return read();
  } catch (const std::invalid_argument &error) {
    refuse("{}: {}", given, error.what());
  }
}

// The value of a field of a scene, of `masses` or of `stop`, in words. Messages begin with `given`.
struct SceneLine {
  std::string name, given, words;
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

// The fields of a scene in words. A force that the scene does not have is zero.
std::vector<FieldInWords> words_of(const Scene &scene);

}  // namespace vibro_impact::runner
