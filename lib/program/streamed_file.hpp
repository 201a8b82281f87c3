// A file written while its text comes, and seen under its name only when it is whole.
#pragma once

#include <cstdio>
#include <string>
#include <string_view>

#include "destination.hpp"

namespace vibro_impact::runner {

class StreamedFile {
 public:
  // Nothing is opened before the first text is written: a run that is refused touches no file.
  explicit StreamedFile(Destination to);
  // What has not been put in place by now is removed.
  ~StreamedFile();
  StreamedFile(const StreamedFile &) = delete;
  StreamedFile &operator=(const StreamedFile &) = delete;

  // Once a write has failed the others do nothing.
  void write(std::string_view text);
  bool failed() const {
    return !error_.empty();
  }

  // Closes the file. Throws std::runtime_error with one line that names it when a write failed.
  void complete();
  // Gives the complete file its name.
  void put_in_place();

 private:
  Destination to_;
  std::FILE *file_ = nullptr;
  bool temporary_ = false;  // a file with the temporary name is there
  std::string error_;       // of the first write that failed

  void fail();
  void throw_error() const;
};

}  // namespace vibro_impact::runner
