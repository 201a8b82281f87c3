// The tables of numbers: their words stand in the files of reference/, the generator fills in what
// it finds.
#pragma once

#include "reference/table_reader.hpp"

#include <cstddef>
#include <fstream>
#include <map>
#include <stdexcept>
#include <string>

namespace vibro_impact_reference {

/// A number as it is written, and an estimate of its error where the table has one.
struct Found {
  std::string value, error = {};
};

/// By the symbol of the row.
using Numbers = std::map<std::string, Found>;

/// The table reference/`name` with these numbers in the columns `value` and `error`. Its words, and
/// the rows of numbers that are printed or reconstructed, stay as they are. Throws
/// std::runtime_error if a number has no row, or a row that is derived or computed no number.
inline std::string filled_table(const std::string &name, const Numbers &numbers) {
  std::ifstream file = vibro_impact::figures::opened(REFERENCE_DIR "/" + name);
  std::string table, line;
  std::getline(file, line);
  table = line + '\n';
  std::size_t filled = 0;
  while (std::getline(file, line)) {
    // symbol,value,kind[,error],words: no quotes in any of the first three or four.
    const auto cells = vibro_impact::figures::cells_of(line);
    const std::string &symbol = cells[0], &kind = cells.at(2);
    const auto found = numbers.find(symbol);
    if (found != numbers.end()) {
      const auto &[value, error] = found->second;
      const std::size_t at = symbol.size() + 1;  // of the value
      line.replace(at, cells[1].size(), value);
      if (!error.empty())
        line.replace(at + value.size() + kind.size() + 2, cells.at(3).size(), error);
      ++filled;
    } else if (kind == "derived" || kind == "computed") {
      throw std::runtime_error("table '" + name + "': nothing found for " + symbol);
    }
    table += line + '\n';
  }
  if (filled != numbers.size())
    throw std::runtime_error("table '" + name + "': a row is missing for what has been found");
  return table;
}

}  // namespace vibro_impact_reference
