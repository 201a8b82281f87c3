// Tables as plain CSV: one header line, 17 significant digits, no half-written file.
#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <initializer_list>
#include <iterator>
#include <stdexcept>
#include <string>

namespace vibro_impact {

// A table under construction; `text` is the CSV so far.
struct Table {
  std::string text;

  explicit Table(const std::string &header) : text(header) {
    text.push_back('\n');
  }

  // Appends one row; floating-point cells get 17 significant digits.
  template <class... Cells>
  void row(const Cells &...cells) {
    bool first = true;
    const auto cell = [this, &first](const auto &value) {
      if (!first) text.push_back(',');
      first = false;
      if constexpr (std::is_floating_point_v<std::remove_cvref_t<decltype(value)>>)
        fmt::format_to(std::back_inserter(text), "{:.17g}", value);
      else
        fmt::format_to(std::back_inserter(text), "{}", value);
    };
    (cell(cells), ...);
    text.push_back('\n');
  }
};

// Writes the table to `path` (`-`: standard output): under a temporary name first, renamed when
// complete. Throws std::runtime_error naming the path when that fails.
inline void write(const Table &table, const std::string &path) {
  if (path == "-") {
    if (std::fwrite(table.text.data(), 1, table.text.size(), stdout) != table.text.size() ||
        std::fflush(stdout) != 0)
      throw std::runtime_error("standard output: cannot be written");
    return;
  }
  const std::string temporary = path + ".part";
  std::FILE *file = std::fopen(temporary.c_str(), "wb");
  bool written = file != nullptr;
  if (written) {
    written = std::fwrite(table.text.data(), 1, table.text.size(), file) == table.text.size();
    written = (std::fclose(file) == 0) && written;
  }
  std::error_code error;
  if (written) std::filesystem::rename(temporary, path, error);
  if (written && !error) return;
  std::filesystem::remove(temporary, error);
  throw std::runtime_error(path + ": cannot be written");
}

}  // namespace vibro_impact
