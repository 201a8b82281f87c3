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

// Throws std::runtime_error naming the place, the column and the rule.
inline Scene scene_in(const Row &row) {
  Scene scene;
  const auto first = std::ranges::find(row.columns(), "masses");
  for (auto name = first; name != row.columns().end() && *name != "note"; ++name) {
    const std::string &words = row.cell(*name);
    if (words.empty()) continue;
    const std::string column = row.place() + ", column " + *name + ": ";
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
