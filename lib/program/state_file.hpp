// The file of a run that can be gone on with: the scene and where the run stood.
//
// Plain text, one `key value ...` per line in a fixed order, numbers in 17 significant digits (so
// that every double comes back exactly). The first line holds the version of the format, the last
// one a checksum of those before it: a file cut short or changed is refused.
#pragma once

#include <istream>
#include <optional>
#include <string>
#include <string_view>

#include "vibro_impact/simulate.hpp"

namespace vibro_impact::runner {

struct SavedRun {
  Scene scene;
  RunState state;
  double time = 0.0;  // the end of the run so far, up to which its tables reach
};

// The whole file; nothing when the state cannot be gone on with, its numbers being out of range.
std::optional<std::string> text_of(const SavedRun &run);

// The last line of a file whose other lines are `text`.
std::string checksum_line(std::string_view text);

// Reads what `text_of` wrote. Throws BadInput with one line that begins with `name` and says what
// is wrong where; std::invalid_argument from `check` and `load` for a scene that makes no sense and
// a state that does not fit it.
SavedRun read_saved_run(std::istream &file, const std::string &name);

// The same from the file at `path`, given as --resume.
SavedRun read_saved_run(const std::string &path);

}  // namespace vibro_impact::runner
