// Where a file goes, settled before the run: a long run must not fail at its end.
#pragma once

#include <string>

#include "options.hpp"

namespace vibro_impact::runner {

struct Destination {
  std::string path = {};  // empty: not wanted; `-`: standard output
  bool direct = false;  // a device, a pipe or an open file: added to, for renaming would replace it

  // The name under which the file is written until it is whole.
  std::string temporary() const {
    return path + ".part";
  }
};

// The destination for the path given with `option`. A link is followed, for the file is renamed
// into place and would otherwise replace the link. Throws BadInput when nothing can be written
// there; leaves nothing behind and touches no file that exists.
Destination destination(const std::string &option, const std::string &given);

// Throws BadInput when two of the files would go to the same place, or over the state to resume.
void require_apart(const Request &request);

}  // namespace vibro_impact::runner
