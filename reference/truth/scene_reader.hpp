// Scenes in tables: from the column `masses` on, a column has the name of a field of a scene, and
// its cells have the value as a scene file has it (vibro_impact/scene_text.hpp). An empty cell
// leaves the field out. A column `note` may follow.
#pragma once

#include <algorithm>
#include <stdexcept>
#include <string>

#include "table_reader.hpp"
#include "vibro_impact/scene_text.hpp"

namespace vibro_impact::truth {

// Throws std::runtime_error naming `place`, the column and the rule.
inline Scene scene_in(const std::string &place, const Row &header, const Row &row) {
  Scene scene;
  const auto first = std::ranges::find(header, "masses");
  for (auto name = first; name != header.end() && *name != "note"; ++name) {
    const std::string &words = row[static_cast<std::size_t>(name - header.begin())];
    if (words.empty()) continue;
    const std::string column = place + ", column " + *name + ": ";
    try {
      if (!set_field(scene, *name, words))
        throw std::runtime_error(column + "is no field of a scene");
    } catch (const std::invalid_argument &error) {
      throw std::runtime_error(column + error.what());
    }
  }
  return scene;
}

}  // namespace vibro_impact::truth
