// The files that the program writes: refused before any work is done, and written whole at the end.
// The rows of a sweep so far stand in a file of their own until the table is complete.
#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "vibro_impact/table.hpp"

namespace vibro_impact::runner {

// The refusal of a command line or a file: throws std::invalid_argument with one line that names
// the value and the rule it breaks.
template <class... Values>
[[noreturn]] void refuse(fmt::format_string<Values...> line, Values &&...values) {
  throw std::invalid_argument(fmt::format(line, std::forward<Values>(values)...));
}

// Refuses these files, each with the option that names it, unless all can be written: in a folder
// that exists, in place of nothing but a file, and each under another name. An empty path is no
// file.
void check_files(const std::vector<std::pair<std::string, std::string>> &files);

// Writes the table to the file, or for `-` to standard output. Throws std::runtime_error with one
// line, and leaves no file, when that fails.
void write_table(const Table &table, const std::string &path);

// The rows of an unfinished sweep, in plain text. The first line names the sweep and the program,
// the second is the header of the table, and rows follow. A sweep that was killed may leave a row
// without its end of line. This row is cut off, and its point is computed again. A lock on the
// file, which ends with the process, keeps a second sweep away.
class PartialTable {
 public:
  // Begins the file at `path`, or extends an existing one. `definition` (one line) names the sweep.
  // `header` is the header of the table, with its end of line. Refuses a file that cannot be
  // opened, that another process has locked, that exists although `resume` is false, or that has
  // another definition or header.
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
