// The journal of an unfinished sweep: its rows are kept in a file until the tables are complete.
#pragma once

#include <array>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

namespace vibro_impact::runner {

// The rows that a point of a sweep has in each table, in the order of SweepRequest::tables, and the
// reason why it has no record, if it has none.
using Texts = std::array<std::string, 4>;

// The line of a journal with these texts, without its end: `row`, the checksum of what follows, the
// number of the row, and the texts, in which a record separator of ASCII stands for the end of a
// line.
std::string journal_line(std::size_t row, const Texts &texts);

// A journal begins with the head, which names the sweep. The lines stand in any order; if a row has
// several, the last counts. A sweep that was killed may leave a last line without its end. Such a
// line is removed, and its row is computed again. A lock on the file, which ends with the process,
// keeps a second sweep away. The rows are in memory, too: whatever becomes of the file, the tables
// of a sweep that ends are right.
class Journal {
 public:
  // Begins the file of a sweep with so many rows at `path`, or reads and extends an existing one.
  // Throws std::invalid_argument for a file that cannot be opened, that another process has locked,
  // that exists although `resume` is false, or that has another head, and for a line that does not
  // fit its checksum.
  Journal(const std::string &path, const std::string &head, std::size_t rows, bool resume);

  bool has(std::size_t row) const {
    return !lines_[row].empty();
  }
  // Adds a journal_line. Throws std::runtime_error when the file cannot be written.
  void add(const std::string &line);
  // The texts of a row that it has.
  Texts texts_of(std::size_t row) const;
  // Removes the file, unless another file has taken its name.
  void remove() const;

 private:
  std::string path_;
  std::unique_ptr<std::FILE, int (*)(std::FILE *)> file_;
  std::vector<std::string> lines_;  // of the rows

  bool is_at_path() const;
  void append(const std::string &text) const;
};

}  // namespace vibro_impact::runner
