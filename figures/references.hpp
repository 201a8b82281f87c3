// Reads the tables of reference/: symbol -> value and kind.
#pragma once

#include <fstream>
#include <map>
#include <stdexcept>
#include <string>

namespace vibro_impact::figures {

struct Reference {
  double value = 0.0;
  std::string kind;  // printed, derived, reconstructed or computed
};
using References = std::map<std::string, Reference>;

// From the first three columns, symbol,value,kind. Throws std::runtime_error, naming the file, when
// it cannot be read or a row is not of this form.
inline References read_references(const std::string &path) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error(path + ": cannot be read");
  References table;
  std::string line;
  std::getline(file, line);
  while (std::getline(file, line)) {
    const std::size_t first = line.find(','), second = line.find(',', first + 1),
                      third = line.find(',', second + 1);
    if (third == std::string::npos) throw std::runtime_error(path + ": a row has too few columns");
    table[line.substr(0, first)] = {std::stod(line.substr(first + 1, second - first - 1)),
                                    line.substr(second + 1, third - second - 1)};
  }
  return table;
}

}  // namespace vibro_impact::figures
