// Tables as plain CSV: one header line, 17 significant digits, no half-written file.
#pragma once

#include <concepts>
#include <string>
#include <string_view>

namespace vibro_impact {

// A table under construction; `text` is the CSV so far.
struct Table {
  std::string text;

  explicit Table(const std::string &header) : text(header + "\n") {
  }

  // Appends one row; floating-point cells get 17 significant digits.
  template <class... Cells>
  void row(const Cells &...cells) {
    (cell(cells), ...);
    end_row();
  }
  void cell(double value);
  void cell(std::string_view value);
  void cell(std::integral auto value) {
    cell(std::string_view(std::to_string(value)));
  }
  // Every cell ends with a comma; that of the last one in a row becomes the end of the line.
  void end_row() {
    if (!text.empty()) text.back() = '\n';
  }
};

// Writes the table to `path`, a file or a new name: as PATH.part first, renamed when complete.
// Throws std::runtime_error naming the path when that fails.
void write(const Table &table, const std::string &path);

}  // namespace vibro_impact
