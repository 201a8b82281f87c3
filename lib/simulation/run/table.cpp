#include "vibro_impact/table.hpp"

#include <array>
#include <charconv>
#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <system_error>

namespace vibro_impact {

namespace {

bool write_all(const std::string &text, std::FILE *file) {
  return std::fwrite(text.data(), 1, text.size(), file) == text.size() && std::fflush(file) == 0;
}

bool write_file(const std::string &text, const std::string &path) {
  std::FILE *file = std::fopen(path.c_str(), "wb");
  if (file == nullptr) return false;
  const bool written = write_all(text, file);
  return std::fclose(file) == 0 && written;
}

}  // namespace

// Every cell ends with a comma; that of the last one in a row becomes the end of the line.
void Table::cell(double value) {
  std::array<char, 40> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value,
                                 std::chars_format::general, 17)
                       .ptr;
  cell(std::string_view(digits.data(), end));
}

void Table::cell(std::string_view value) {
  text.append(value);
  text.push_back(',');
}

void Table::end_row() {
  if (text.back() == ',')
    text.back() = '\n';
  else
    text.push_back('\n');
}

void write(const Table &table, const std::string &path) {
  if (path == "-") {
    if (!write_all(table.text, stdout))
      throw std::runtime_error("standard output: cannot be written");
    return;
  }
  const std::string temporary = path + ".part";
  const bool written = write_file(table.text, temporary);
  std::error_code error;
  if (written) std::filesystem::rename(temporary, path, error);
  if (written && !error) return;
  std::filesystem::remove(temporary, error);
  throw std::runtime_error(path + ": cannot be written");
}

}  // namespace vibro_impact
