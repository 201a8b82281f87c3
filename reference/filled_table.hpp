// The tables of numbers: their words stand in the files of reference/, the generator fills in what
// it finds.
#pragma once

#include "digits.hpp"

#include <cstddef>
#include <fstream>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

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
  std::ifstream file(REFERENCE_DIR "/" + name);
  if (!file) throw std::runtime_error("table '" + name + "': cannot be read");
  std::string table, line;
  std::getline(file, line);
  table = line + '\n';
  std::size_t filled = 0;
  while (std::getline(file, line)) {
    // symbol,value,kind[,error],words: no commas in any of the first three or four.
    std::vector<std::size_t> commas;
    for (std::size_t at = line.find(','); at != std::string::npos; at = line.find(',', at + 1))
      commas.push_back(at);
    const std::string symbol = line.substr(0, commas.at(0));
    const std::string kind = line.substr(commas.at(1) + 1, commas.at(2) - commas[1] - 1);
    const auto found = numbers.find(symbol);
    if (found != numbers.end()) {
      const auto &[value, error] = found->second;
      if (!error.empty()) line.replace(commas[2] + 1, commas.at(3) - commas[2] - 1, error);
      line.replace(commas[0] + 1, commas[1] - commas[0] - 1, value);
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
