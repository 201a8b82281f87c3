#include "vibro_impact/table.hpp"

#include <array>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <system_error>

namespace vibro_impact {

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

void write(const Table &table, const std::string &path) {
  std::error_code error;
  const std::filesystem::file_status there = std::filesystem::status(path, error);
  if (std::filesystem::exists(there) && !std::filesystem::is_regular_file(there))
    throw std::runtime_error(path + ": is no file, cannot be replaced by one");
  const std::string temporary = path + ".part";
  std::ofstream file(temporary, std::ios::binary);
  file << table.text;
  file.close();
  if (file) std::filesystem::rename(temporary, path, error);
  if (file && !error) return;
  std::filesystem::remove(temporary, error);
  throw std::runtime_error(path + ": cannot be written");
}

}  // namespace vibro_impact
