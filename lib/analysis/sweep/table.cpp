#include "vibro_impact/analysis/table.hpp"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <system_error>

namespace vibro_impact {

void Table::cell(double value) {
  cell(value, 0.0);
}

void Table::cell(double value, double error) {
  int significant = 17;
  if (error > 0.0 && value != 0.0 && std::isfinite(value)) {
    const double decades = std::floor(std::log10(std::abs(value))) - std::floor(std::log10(error));
    significant = static_cast<int>(std::clamp(decades + 2.0, 1.0, 17.0));
  }
  std::array<char, 40> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value,
                                 std::chars_format::general, significant)
                       .ptr;
  cell(std::string_view(digits.data(), end));
}

void Table::cell(std::string_view value) {
  text.append(value);
  text.push_back(',');
}

void write(const Table &table, const std::string &path) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::path target = fs::weakly_canonical(path, error);  // a link is written through
  if (error) throw std::runtime_error(path + ": cannot be written: " + error.message());
  if (fs::exists(target) && !fs::is_regular_file(target))
    throw std::runtime_error(path + ": is no file, cannot be replaced by one");
  const std::string temporary = target.string() + ".part." + std::to_string(getpid());
  std::FILE *file = std::fopen(temporary.c_str(), "wbx");
  const std::size_t size = table.text.size();
  const bool whole = file != nullptr && std::fwrite(table.text.data(), 1, size, file) == size &&
                     std::fflush(file) == 0;
  if (!whole) error = {errno, std::generic_category()};
  if (file != nullptr) std::fclose(file);
  if (whole) fs::rename(temporary, target, error);
  if (!error) return;
  const std::string reason = error.message();
  if (file != nullptr) fs::remove(temporary, error);
  throw std::runtime_error(path + ": cannot be written: " + reason);
}

}  // namespace vibro_impact
