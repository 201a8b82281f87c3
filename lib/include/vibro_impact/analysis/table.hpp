// Tables as CSV text with one header line and 17 significant digits. A file appears under its name
// only when its table is complete.
#pragma once

#include <concepts>
#include <string>
#include <string_view>

namespace vibro_impact {

// A table to which rows are added. `text` is the CSV text so far. A table without a header has rows
// alone.
struct Table {
  std::string text = {};

  Table() = default;
  explicit Table(const std::string &header) : text(header + "\n") {
  }

  // Appends one row. Floating-point cells get 17 significant digits.
  template <class... Cells>
  void row(const Cells &...cells) {
    (cell(cells), ...);
    end_row();
  }
  // The value to the second digit of its error. An error of 0 asks for 17 digits.
  void cell(double value, double error = 0.0);
  void cell(std::string_view value);
  void cell(std::integral auto value) {
    cell(std::string_view(std::to_string(value)));
  }
  // Every cell ends with a comma. `end_row` replaces the last comma of a row by the end of the
  // line.
  void end_row() {
    if (!text.empty()) text.back() = '\n';
  }
};

// Writes the table to a new file beside `path` and renames this file to `path`. A file of that name
// is replaced, and a symbolic link is written through. Throws std::runtime_error, with the path and
// the reason, if that fails.
void write(const Table &table, const std::string &path);

}  // namespace vibro_impact
