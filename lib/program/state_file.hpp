// The file of a run that can be gone on with: the scene and where the run stood.
//
// Plain text: the version of the format and a checksum of the rest; the options that gave the
// scene, in one line; the time; the lines in which the library keeps its state.
#pragma once

#include <istream>
#include <string>
#include <string_view>

#include "vibro_impact/simulate.hpp"

namespace vibro_impact::runner {

struct SavedRun {
  std::string scene_text;  // as in Request
  Scene scene;
  RunState state;
  double time = 0.0;  // the end of the run so far, up to which its tables reach
};

// The whole file.
std::string text_of(const SavedRun &run);

// The first line of a file, before the others.
std::string first_line(std::string_view others);

// Reads what `text_of` wrote. Throws std::invalid_argument with one line that begins with `name`
// and says what is wrong.
SavedRun read_saved_run(std::istream &file, const std::string &name);

}  // namespace vibro_impact::runner
