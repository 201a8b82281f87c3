// The table of key numbers, whose words stand in the file and whose values the generator fills in.
#pragma once

#include "reference/table_reader.hpp"

#include <fstream>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace vibro_impact_reference {

/// The digits of a number by the symbol of its row.
using Numbers = std::map<std::string, std::string>;

/// A row of a table. A cell with a comma stands in quotes.
inline std::string line_of(const std::vector<std::string> &cells) {
  std::string line;
  for (const std::string &cell : cells) {
    if (&cell != &cells.front()) line += ',';
    line += cell.find(',') == std::string::npos ? cell : '"' + cell + '"';
  }
  return line + '\n';
}

/// The table reference/`name`, of which the first columns are symbol and value, with these values.
/// All other cells stay as they are. Throws std::runtime_error if a number has no row, or a row no
/// number.
inline std::string filled_table(const std::string &name, Numbers numbers) {
  std::ifstream file = vibro_impact::figures::opened(REFERENCE_DIR "/" + name);
  std::string table, line;
  std::getline(file, line);
  table = line + '\n';
  while (std::getline(file, line)) {
    std::vector<std::string> cells = vibro_impact::figures::cells_of(line);
    const auto found = numbers.find(cells.at(0));
    if (found == numbers.end())
      throw std::runtime_error("table '" + name + "': nothing was found for " + cells[0]);
    cells.at(1) = found->second;
    table += line_of(cells);
    numbers.erase(found);
  }
  if (!numbers.empty())
    throw std::runtime_error("table '" + name + "': it has no row for " + numbers.begin()->first);
  return table;
}

}  // namespace vibro_impact_reference
