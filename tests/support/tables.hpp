// Tables read back, and those of the drivers of the figures with the true events to compare them
// with.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "events.hpp"
#include "reference/scenes/paper_scenes.hpp"
#include "reference/truth/event_reader.hpp"
#include "reference/truth/table_reader.hpp"

namespace vibro_impact::testing {

// A table by the names of its columns, so that another column changes nothing.
class NamedColumns {
 public:
  explicit NamedColumns(const std::string &table)
      : names_(truth::cells_of(table.substr(0, table.find('\n')))) {
    std::istringstream text(table);
    rows_ = truth::read_rows(text, "table", names_.size());
  }
  std::size_t rows() const {
    return rows_.size();
  }
  const std::string &cell(const std::string &column, std::size_t row = 0) const {
    const auto k = std::ranges::find(names_, column) - names_.begin();
    return rows_.at(row).at(static_cast<std::size_t>(k));
  }
  // NaN for an empty cell and for a word.
  double number(const std::string &column, std::size_t row = 0) const {
    return truth::as_number(cell(column, row)).value_or(NAN);
  }

 private:
  truth::Row names_;
  truth::Rows rows_ = {};
};

// Runs the driver of a figure. Returns the folder of its tables, which is that of one test in this
// build, since several tests run at once. Throws std::runtime_error if the driver fails.
inline std::string tables_of(const std::string &figure, const std::string &test) {
  const std::string folder = PROGRAM_DIR "/../tables_of_tests/" + test;
  const std::string command = "'" PROGRAM_DIR "/" + figure + "' --output '" + folder + "'";
  if (std::system(command.c_str()) != 0) throw std::runtime_error(command + ": failed");
  return folder;
}

// The columns of a table by their names. Only cells that are numbers count.
using Columns = std::map<std::string, std::vector<double>>;

inline Columns columns_of(const std::string &path) {
  const truth::Row names = truth::header_of(path);
  Columns columns;
  for (const auto &cells : truth::read_rows(path, names.size()))
    for (std::size_t i = 0; i < names.size(); ++i)
      if (const auto value = truth::as_number(cells[i])) columns[names[i]].push_back(*value);
  return columns;
}

inline std::vector<Event> true_events(const std::string &scene) {
  return truth::read_event_table(REFERENCE_DIR "/" + scene + "_events.csv");
}

// Each mass of the paper's scenes has one stop.
inline double stop_position(const Scene &scene, int mass) {
  return scene.stops[static_cast<std::size_t>(mass - 1)].position;
}

inline bool holds(const Held &held, int mass) {
  const auto i = static_cast<std::size_t>(mass - 1);
  return i < held.size() && held[i] != 0;
}

}  // namespace vibro_impact::testing
