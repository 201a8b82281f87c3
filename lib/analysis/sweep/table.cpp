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
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value + 0.0,
                                 std::chars_format::general, significant)
                       .ptr;
  cell(std::string_view(digits.data(), end));
}

void Table::cell(std::string_view value) {
  text.append(value);
  text.push_back(',');
}

namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const std::string &path, const std::error_code &error) {
  throw std::runtime_error(path + ": cannot be written: " + error.message());
}

}  // namespace

TableFile::TableFile(const std::string &path) : path_(path), file_(nullptr, std::fclose) {
  std::error_code error;
  if (fs::is_fifo(path, error)) {
    file_.reset(std::fopen(path.c_str(), "wb"));
  } else {
    const fs::path target = fs::weakly_canonical(path, error);  // a link is written through
    if (error) fail(path, error);
    if (fs::exists(target) && !fs::is_regular_file(target))
      throw std::runtime_error(path + ": is no file, cannot be replaced by one");
    target_ = target.string();
    temporary_ = target_ + ".part." + std::to_string(getpid());
    file_.reset(std::fopen(temporary_.c_str(), "wbx"));
  }
  if (!file_) fail(path, {errno, std::generic_category()});
}

TableFile::~TableFile() {
  std::error_code error;
  if (file_ && !temporary_.empty()) fs::remove(temporary_, error);
}

void TableFile::append(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), file_.get()) != text.size() ||
      std::fflush(file_.get()) != 0)
    fail(path_, {errno, std::generic_category()});
}

void TableFile::finish() {
  std::error_code error;
  if (!temporary_.empty()) fs::rename(temporary_, target_, error);
  if (error) fail(path_, error);
  file_.reset();
}

void write(const Table &table, const std::string &path) {
  TableFile file(path);
  file.append(table.text);
  file.finish();
}

}  // namespace vibro_impact
