// The files that the program writes: refused before any work is done, and written whole at the end.
// The rows of a sweep are kept in a journal until its tables are complete.
#pragma once

#include <fmt/format.h>

#include <array>
#include <boost/crc.hpp>
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

std::uint32_t checksum_of(const std::string &bytes);

// A path of the open file or pipe itself, whatever has become of its name (in Linux).
std::string path_of(std::FILE *file);

// Writes the text to the file, or for `-` to standard output. Throws std::runtime_error with one
// line, and leaves no file, when that fails.
void write_text(std::string text, const std::string &path);

// The rows of the tables of a sweep, in the order of SweepRequest::files.
using Texts = std::array<std::string, 3>;

// The journal of an unfinished sweep. It keeps all rows in memory, and appends them block by block
// to a file, which is read once, by a sweep that resumes this one.
//
// The file begins with the head, which names the sweep. A block has the rows of each table, with a
// line `#` between two tables. It ends with a line `# crc <checksum>` of everything above this
// line. A sweep that was killed may leave a block without this line. Such a block is cut off, and
// its points are computed again. A lock on the file, which ends with the process, keeps a second
// sweep away.
class Journal {
 public:
  // Whether this is row k of the first table.
  using RowRule = std::function<bool(std::size_t k, std::string_view row)>;

  // Begins the file at `path`, or reads and extends an existing one. Throws std::invalid_argument
  // for a file that cannot be opened, that another process has locked, that exists although
  // `resume` is false, or that has another head. Throws it also for a row that breaks the rule and
  // for blocks that do not fit their checksum, with the number of the line.
  Journal(const std::string &path, const std::string &head, bool resume, const RowRule &rule);

  const Texts &rows() const {
    return rows_;
  }
  // The number of rows of the first table.
  std::size_t size() const;
  // Adds a block. Throws std::runtime_error when the file cannot be written.
  void add(const Texts &block);
  // Removes the file, unless another file has taken its name. Returns false if another program
  // has changed, moved or removed the file since it was opened.
  bool remove();

 private:
  std::string path_;
  std::unique_ptr<std::FILE, int (*)(std::FILE *)> file_;
  Texts rows_ = {};
  boost::crc_32_type checksum_;  // of the file

  bool is_at_path() const;
  void append(const std::string &text);
  std::size_t read(const std::string &text, std::size_t head, const RowRule &rule);
};

}  // namespace vibro_impact::runner
