// A file that is written while its text comes, and has its name only when it is whole.
#pragma once

#include <cstdio>
#include <string>
#include <string_view>

#include "vibro_impact/table.hpp"

namespace vibro_impact::runner {

// Where a file of that name goes. Throws std::invalid_argument for what cannot be written; makes no
// file.
struct Destination {
  std::string path;     // of standard output: -
  bool direct = false;  // that, a device, a pipe or an open file: renaming would replace it

  explicit Destination(const std::string &name);
};

class Output {
 public:
  // Opens the file, beside its name until it is whole. Throws std::invalid_argument when that
  // fails, also because another of the program's files goes there.
  explicit Output(const std::string &name);
  // What has not been put in place by now is removed.
  ~Output();
  Output(const Output &) = delete;
  Output &operator=(const Output &) = delete;

  // Where the file stands until it is put in place; empty: at its place.
  const std::string &temporary() const {
    return temporary_;
  }
  // Once a write has failed the others do nothing.
  void write(std::string_view text);
  void take(Table &rows);  // and leaves it empty
  bool failed() const {
    return error_ != 0;
  }
  // Closes the file. Throws std::runtime_error with one line that names it when a write failed, and
  // EndedBySignal when the reader of a pipe has left, which is no error.
  void complete();
  // Gives the complete file its name.
  void put_in_place();

 private:
  Destination to_;
  std::string temporary_;
  std::FILE *file_;
  int error_ = 0;  // of the first write that failed
};

}  // namespace vibro_impact::runner
