// The rows of a sweep so far, in a file of their own until the table is complete.
//
// The file is plain text: a line that says which sweep and which program it is of, the header of
// the table, then rows. What a sweep that was killed has left of a row has no end of its line: it
// is cut off, and its point computed again. A lock on the file, which ends with the process, keeps
// a second sweep away.
#pragma once

#include <cstddef>
#include <cstdio>
#include <memory>
#include <string>

namespace vibro_impact::runner {

class PartialTable {
 public:
  // Begins the file at `path`, or goes on with the one that is there. `definition` (one line) says
  // of which sweep it is; `header` is that of the table, with the end of its line. Throws
  // std::invalid_argument when the file cannot be opened, when another process has it, when it is
  // there and `resume` is false, and when it is of another definition or header.
  PartialTable(const std::string &path, const std::string &definition, const std::string &header,
               bool resume);

  std::size_t rows() const {
    return rows_;
  }
  // Adds rows, each with the end of its line. Throws std::runtime_error when that fails.
  void add(const std::string &rows);
  // The table so far: its header and its rows.
  std::string text() const;
  // Removes the file.
  void remove();

 private:
  std::string path_, definition_;
  std::unique_ptr<std::FILE, int (*)(std::FILE *)> file_;
  std::size_t rows_ = 0;

  void append(const std::string &text);
};

}  // namespace vibro_impact::runner
