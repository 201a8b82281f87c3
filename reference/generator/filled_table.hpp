// The table of key numbers, whose words stand in the file and whose values the generator fills in.
#pragma once

#include "reference/truth/table_reader.hpp"

#include <fstream>
#include <map>
#include <stdexcept>
#include <string>

namespace vibro_impact_reference {

/// The digits of a number by the symbol of its row.
using Numbers = std::map<std::string, std::string>;

/// The table reference/tables/`name`, of which the first columns are symbol and value, with these
/// values. All other cells stay as they are. Throws std::runtime_error if a number has no row, or a
/// row no number.
inline std::string filled_table(const std::string &name, Numbers numbers) {
  std::ifstream file = vibro_impact::truth::opened(REFERENCE_DIR "/" + name);
  std::string table, line;
  std::getline(file, line);
  table = line + '\n';
  while (std::getline(file, line)) {
    const auto comma = line.find(','), rest = line.find(',', comma + 1);
    const std::string symbol = line.substr(0, comma);
    const auto found = numbers.find(symbol);
    if (found == numbers.end())
      throw std::runtime_error("table '" + name + "': nothing was found for " + symbol);
    table += symbol + ',' + found->second + line.substr(rest) + '\n';
    numbers.erase(found);
  }
  if (!numbers.empty())
    throw std::runtime_error("table '" + name + "': it has no row for " + numbers.begin()->first);
  return table;
}

}  // namespace vibro_impact_reference
