/// \file
/// Tables as CSV text with one header line and 17 significant digits. A file appears under its name
/// only when its table is complete.
#pragma once

#include <concepts>
#include <cstdio>
#include <memory>
#include <string>
#include <string_view>

namespace vibro_impact {

/// A table to which rows are added. `text` is the CSV text so far. A table without a header has
/// rows alone.
struct Table {
  std::string text = {};

  Table() = default;
  explicit Table(const std::string &header) : text(header + "\n") {
  }

  /// Appends one row. Floating-point cells get 17 significant digits.
  template <class... Cells>
  void row(const Cells &...cells) {
    (cell(cells), ...);
    end_row();
  }
  /// The value to the second digit of its error. An error of 0 asks for 17 digits. A zero has no
  /// sign.
  void cell(double value, double error = 0.0);
  void cell(std::string_view value);
  void cell(std::integral auto value) {
    cell(std::string_view(std::to_string(value)));
  }
  /// Every cell ends with a comma. `end_row` replaces the last comma of a row by the end of the
  /// line.
  void end_row() {
    if (!text.empty()) text.back() = '\n';
  }
};

/// A file that appears under its name when it is complete. The text goes to a new file beside it,
/// which is renamed at the end. A file of that name is replaced, and a symbolic link is written
/// through. A pipe gets the text at once. The functions throw std::runtime_error, with the path and
/// the reason, when they fail.
class TableFile {
 public:
  explicit TableFile(const std::string &path);
  TableFile(TableFile &&) = default;
  ~TableFile();  ///< removes the new file, unless it was renamed

  void append(std::string_view text);
  void finish();  ///< gives the file its name

 private:
  std::string path_, target_ = {}, temporary_ = {};  ///< the new file; empty: a pipe
  std::unique_ptr<std::FILE, int (*)(std::FILE *)> file_;
};

/// Writes the whole table to a file of this name, as a TableFile.
void write(const Table &table, const std::string &path);

}  // namespace vibro_impact
