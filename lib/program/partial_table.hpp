// The rows of a sweep so far, in a file of their own until the table is complete.
//
// Plain text: what sweep it is, the header of the table, then rows and, every few of them, a line
// with the number of points so far and a checksum of everything before it. Rows after the last such
// line may have been cut short: they are dropped, and computed again. A file changed before it is
// refused. One sweep at a time holds the file: it is locked and stays open until the table is
// there, and that it is still the file that was written is looked at with every checksum.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdio>
#include <functional>
#include <string>
#include <string_view>

#include "checksum.hpp"
#include "output.hpp"

namespace vibro_impact::runner {

class PartialTable {
 public:
  // Begins the file at `path`, or goes on with the one that is there. `definition` (one line)
  // says of which sweep it is, `header` is that of the table, with the end of its line. Throws
  // BadInput for a file that is there and not to be gone on with, that another sweep writes, that
  // is damaged, or of another sweep; std::runtime_error when it cannot be written.
  PartialTable(std::string path, const std::string &definition, const std::string &header,
               bool resume);
  ~PartialTable();
  PartialTable(const PartialTable &) = delete;
  PartialTable &operator=(const PartialTable &) = delete;

  std::size_t points() const {
    return points_;
  }
  // The row of the next point, with the end of its line. Throws std::runtime_error when it cannot
  // be written, and when the file was removed or cut in the meantime.
  void add(std::string_view row);
  // Writes the table, read back and checked, to where it belongs, and removes this file. Throws
  // std::runtime_error, and leaves a table that was there, unless all rows stand in the file.
  void finish(const Named &table);

 private:
  std::string path_, head_;
  std::FILE *file_ = nullptr;
  Checksum checksum_ = {};
  std::size_t points_ = 0, closed_ = 0;  // points, and those under a checksum
  std::size_t size_ = 0;                 // of the file up to there
  std::string open_ = {};                // rows not yet written
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();

  bool is_ours() const;
  void read(const std::function<void(std::string_view)> &take);
  void close_rows();
};

}  // namespace vibro_impact::runner
