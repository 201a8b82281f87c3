// The arguments of a quantity, as a table has them: "scene=figure2 mass=2 from=700".
#pragma once

#include <fmt/format.h>

#include <map>
#include <sstream>
#include <stdexcept>
#include <string>

#include "reference/truth/table_reader.hpp"

namespace vibro_impact::numbers {

struct Arguments {
  std::map<std::string, std::string> values;

  bool contains(const std::string &name) const {
    return values.contains(name);
  }
  // Throws std::runtime_error naming a missing argument.
  const std::string &text(const std::string &name) const {
    const auto found = values.find(name);
    if (found == values.end()) throw std::runtime_error("argument '" + name + "': is missing");
    return found->second;
  }
  // Throws std::runtime_error naming a missing argument, and text that is not a number.
  double at(const std::string &name) const {
    return truth::number_in("argument '" + name + "'", text(name));
  }
  double at(const std::string &name, double otherwise) const {
    return contains(name) ? at(name) : otherwise;
  }
  // A mass, counted from 1; 0 if none is given.
  int mass(const std::string &name) const {
    return static_cast<int>(at(name, 0.0));
  }
};

// Throws std::runtime_error naming the table and a word that is not name=value, or a name given
// twice.
inline Arguments read_arguments(const std::string &table, const std::string &cell) {
  Arguments arguments;
  std::istringstream words(cell);
  for (std::string word; words >> word;) {
    const auto equals = word.find('=');
    if (equals == std::string::npos)
      throw std::runtime_error(fmt::format("{}: '{}' is not name=value", table, word));
    const std::string name = word.substr(0, equals);
    if (!arguments.values.emplace(name, word.substr(equals + 1)).second)
      throw std::runtime_error(fmt::format("{}: '{}' is given twice", table, name));
  }
  return arguments;
}

// Throws std::runtime_error for an argument that is not among `names`, which blanks separate.
inline void require_only(const Arguments &arguments, const std::string &names) {
  for (const auto &[name, value] : arguments.values)
    if ((' ' + names + ' ').find(' ' + name + ' ') == std::string::npos)
      throw std::runtime_error(fmt::format("argument '{}': must be one of {}", name, names));
}

}  // namespace vibro_impact::numbers
