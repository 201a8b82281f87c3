// Reading the CSV tables of reference/: rows of cells, and numbers that are numbers.
#pragma once

#include <fmt/format.h>

#include <boost/tokenizer.hpp>
#include <charconv>
#include <cmath>
#include <fstream>
#include <istream>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace vibro_impact::truth {

// A table opened for reading. Throws std::runtime_error naming it.
inline std::ifstream opened(const std::string &path) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error(path + ": cannot be read");
  return file;
}

using Row = std::vector<std::string>;  // of cells
using Rows = std::vector<Row>;

// The cells of a line; one in double quotes may hold commas, and is given without the quotes.
inline Row cells_of(const std::string &line) {
  using Separator = boost::escaped_list_separator<char>;
  const boost::tokenizer<Separator> cells(line, Separator("", ",", "\""));  // without escapes
  return {cells.begin(), cells.end()};
}

// A cell of text that may hold commas.
inline std::string in_quotes(const std::string &text) {
  return '"' + text + '"';
}

// The cells of the header line.
inline Row header_of(const std::string &path) {
  std::ifstream file = opened(path);
  std::string line;
  std::getline(file, line);
  return cells_of(line);
}

// The place of a row, counted from 0, for a message.
inline std::string line_of(const std::string &name, std::size_t row) {
  return fmt::format("{}: line {}", name, row + 2);
}

// The rows below the header line. Throws std::runtime_error naming `name` and the line of a row
// with fewer than `columns` cells.
inline Rows read_rows(std::istream &file, const std::string &name, std::size_t columns) {
  Rows rows;
  std::string line;
  std::getline(file, line);
  while (std::getline(file, line)) {
    Row cells = cells_of(line);
    if (cells.size() < columns)
      throw std::runtime_error(fmt::format("{} has {} columns, {} are needed",
                                           line_of(name, rows.size()), cells.size(), columns));
    rows.push_back(std::move(cells));
  }
  return rows;
}

inline Rows read_rows(const std::string &path, std::size_t columns) {
  std::ifstream file = opened(path);
  return read_rows(file, path, columns);
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

}  // namespace vibro_impact::truth
