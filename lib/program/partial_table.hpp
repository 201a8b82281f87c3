// The rows of a sweep so far, in a file of their own until the table is complete.
//
// Plain text: what sweep it is, the header of the table, then rows, each with a checksum of all
// rows up to it. A last line that was cut short is dropped, and its point computed again; a file
// that was changed is refused. One sweep at a time holds the file: it is locked and stays open
// until the table is there, whatever happens to its name.
#pragma once

#include <boost/crc.hpp>
#include <cstddef>
#include <cstdio>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

namespace vibro_impact::runner {

class PartialTable {
 public:
  // Begins the file at `path`, or goes on with the one that is there. `definition` (one line)
  // says of which sweep it is, `header` is that of the table, with the end of its line. Throws
  // std::invalid_argument for a file that is there and not to be gone on with, that another sweep
  // writes, that was changed, or of another sweep, and when it cannot be opened.
  PartialTable(std::string path, const std::string &definition, const std::string &header,
               bool resume);

  std::size_t points() const {
    return points_;
  }
  // The row of the next point, with the end of its line. Throws std::runtime_error when it cannot
  // be written.
  void add(std::string_view row);
  // Writes the table, read back and checked, to where it belongs, and removes this file. Throws,
  // and leaves a table that was there, unless all rows stand in the file.
  void finish(const std::string &name);

 private:
  std::string path_, held_, head_;  // held_: the file, whatever has its name; head_: first lines
  std::unique_ptr<std::FILE, int (*)(std::FILE *)> file_;
  boost::crc_32_type checksum_;
  std::size_t points_ = 0;

  std::size_t read(const std::function<void(std::string_view)> &take);
  void append(const std::string &text);
};

}  // namespace vibro_impact::runner
