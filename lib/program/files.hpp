// The files that the program writes: refused before any work is done, and written whole at the end.
// The rows of a sweep are kept in a journal until its tables are complete.
#pragma once

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "vibro_impact/analysis/table.hpp"

namespace vibro_impact::runner {

// The refusal of a command line or a file: throws std::invalid_argument with one line that names
// the value and the rule it breaks.
template <class... Values>
[[noreturn]] void refuse(fmt::format_string<Values...> line, Values &&...values) {
  throw std::invalid_argument(fmt::format(line, std::forward<Values>(values)...));
}

// The reason why a run was given up, with the option that allows more steps if it had too many.
std::string with_remedy(const std::string &reason);

// The columns of a list behind others: ,name1,name2,...
std::string numbered_columns(const std::string &name, std::size_t count);

// A file that a command writes, and the option that names it. An empty path means that the file is
// not wanted; `-` is standard output.
struct Output {
  std::string option, path = {};

  bool wanted() const {
    return !path.empty();
  }
  bool is_file() const {
    return wanted() && path != "-";
  }
  std::string given() const {
    return option + " " + path;
  }
};

// Refuses these outputs unless all can be written: in a folder that exists and is not
// write-protected, in place of nothing but a file, and each under another name, which is not that
// of the file of the scene.
void check_outputs(const std::vector<Output> &outputs, const std::string &scene_file);

// The bytes of a file. A file that cannot be read has none.
std::string contents(const std::string &path);

std::uint32_t checksum_of(std::string_view bytes);

// A path of the open file or pipe itself, whatever has become of its name (in Linux).
std::string path_of(std::FILE *file);

// Writes the text to the file, or for `-` to standard output. Throws std::runtime_error with one
// line, and leaves no file, when that fails.
void write_text(std::string text, const std::string &path);

// The rows that a point of a sweep has in each table, in the order of SweepRequest::tables, and the
// reason why it has no record, if it has none.
using Texts = std::array<std::string, 4>;

// The line of a journal with these texts: `row`, the checksum of what follows, the number of the
// row, and the texts, in which a record separator of ASCII stands for the end of a line.
std::string journal_line(std::size_t row, const Texts &texts);

// The journal of an unfinished sweep: a file of which the memory has the places of the lines only.
// It begins with the head, which names the sweep. The lines stand in any order; if a row has
// several, the last counts. A sweep that was killed may leave a last line without its end. Such a
// line is removed, and its row is computed again. A lock on the file, which ends with the process,
// keeps a second sweep away.
class Journal {
 public:
  // Begins the file of a sweep with so many rows at `path`, or reads and extends an existing one.
  // Throws std::invalid_argument for a file that cannot be opened, that another process has locked,
  // that exists although `resume` is false, or that has another head, and for a line that does not
  // fit its checksum.
  Journal(const std::string &path, const std::string &head, std::size_t rows, bool resume);

  bool has(std::size_t row) const {
    return places_[row] != 0;
  }
  // Adds a journal_line. Throws std::runtime_error when the file cannot be written.
  void add(const std::string &line);
  // Calls `use` with the texts of all rows, in the order of the rows. Throws std::runtime_error for
  // a row that another program has changed since it was added.
  void read(const std::function<void(const Texts &texts)> &use) const;
  // Removes the file, unless another file has taken its name. Returns false if another program
  // has moved, removed or extended the file since it was opened.
  bool remove();

 private:
  std::string path_;
  std::unique_ptr<std::FILE, int (*)(std::FILE *)> file_;
  std::vector<std::uint64_t> places_;  // of the lines in the file; 0: none
  std::uint64_t end_ = 0;              // of the last line

  bool is_at_path() const;
  void append(const std::string &text);
  std::string damage_at(std::uint64_t place) const;
};

}  // namespace vibro_impact::runner
