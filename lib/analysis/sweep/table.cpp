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
  const auto require_done = [&](bool done) {
    if (!done) error = {errno, std::generic_category()};
    if (error) throw std::runtime_error(path + ": cannot be written: " + error.message());
  };
  require_done(file != nullptr);
  try {
    require_done(std::fwrite(table.text.data(), 1, table.text.size(), file) == table.text.size());
    require_done(std::fflush(file) == 0);
    fs::rename(temporary, target, error);
    require_done(!error);
  } catch (...) {
    fs::remove(temporary, error);
    std::fclose(file);
    throw;
  }
  std::fclose(file);
}

}  // namespace vibro_impact
