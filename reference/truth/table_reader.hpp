// Reading CSV tables: cells by the names of their columns, and numbers that are numbers.
#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <boost/tokenizer.hpp>
#include <charconv>
#include <cmath>
#include <fstream>
#include <istream>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace vibro_impact::truth {

// A table opened for reading. Throws std::runtime_error naming it.
inline std::ifstream opened(const std::string &path) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error(path + ": cannot be read");
  return file;
}

using Cells = std::vector<std::string>;

// The cells of a line; one in double quotes may hold commas, and is given without the quotes.
inline Cells cells_of(const std::string &line) {
  using Separator = boost::escaped_list_separator<char>;
  const boost::tokenizer<Separator> cells(line, Separator("", ",", "\""));  // without escapes
  return {cells.begin(), cells.end()};
}

// A whole cell as a number; nothing for other text.
inline std::optional<double> as_number(const std::string &cell) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (error != std::errc() || end != cell.data() + cell.size()) return std::nullopt;
  return value;
}

// The same where it must be one. Throws std::runtime_error naming `name` and the cell; infinities
// and NaN are no entries of a table.
inline double number_in(const std::string &name, const std::string &cell) {
  const auto value = as_number(cell);
  if (!value || !std::isfinite(*value))
    throw std::runtime_error(fmt::format("{}: '{}' is not a number", name, cell));
  return *value;
}

// The place of a cell among words. Throws std::runtime_error naming `place` for any other cell.
template <std::size_t n>
std::size_t word_in(const std::string &place, const std::string &cell,
                    const char *const (&words)[n]) {
  const auto found = std::find(words, words + n, cell);
  if (found == words + n)
    throw std::runtime_error(
        fmt::format("{}: '{}' is none of: {}", place, cell, fmt::join(words, words + n, ", ")));
  return static_cast<std::size_t>(found - words);
}

// A row of a table, with its cells by the names of their columns, and its place for messages.
// Another column, or another order of them, changes nothing.
class Row {
 public:
  Row(std::shared_ptr<const Cells> columns, Cells cells, std::string place)
      : columns_(std::move(columns)), cells_(std::move(cells)), place_(std::move(place)) {
  }

  const Cells &columns() const {
    return *columns_;
  }
  // In the order of the columns. A table may have cells beyond the last column.
  const Cells &cells() const {
    return cells_;
  }
  // The table and the line.
  const std::string &place() const {
    return place_;
  }
  // Throws std::runtime_error naming the place and a column that the table has not.
  const std::string &cell(const std::string &column) const {
    const auto found = std::ranges::find(*columns_, column);
    if (found == columns_->end())
      throw std::runtime_error(fmt::format("{}: there is no column '{}'", place_, column));
    return cells_[static_cast<std::size_t>(found - columns_->begin())];
  }
  // Throws std::runtime_error naming the place and a cell that is not a finite number.
  double number(const std::string &column) const {
    return number_in(place_, cell(column));
  }

 private:
  std::shared_ptr<const Cells> columns_;
  Cells cells_;
  std::string place_;
};

using Rows = std::vector<Row>;

// The rows below the header line. Throws std::runtime_error naming `name` and the line of a row
// with fewer cells than the header.
inline Rows read_rows(std::istream &file, const std::string &name) {
  std::string line;
  std::getline(file, line);
  const auto columns = std::make_shared<const Cells>(cells_of(line));
  Rows rows;
  while (std::getline(file, line)) {
    const std::string place = fmt::format("{}: line {}", name, rows.size() + 2);
    Cells cells = cells_of(line);
    if (cells.size() < columns->size())
      throw std::runtime_error(
          fmt::format("{} has {} of {} columns", place, cells.size(), columns->size()));
    rows.emplace_back(columns, std::move(cells), place);
  }
  return rows;
}

inline Rows read_rows(const std::string &path) {
  std::ifstream file = opened(path);
  return read_rows(file, path);
}

}  // namespace vibro_impact::truth
