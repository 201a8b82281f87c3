// The axes of the paper's panels, all printed, as reference/tables/panels.csv has them. The scripts
// of gnuplot read the same table.
#pragma once

#include <map>
#include <stdexcept>
#include <string>

#include "reference/truth/table_reader.hpp"

namespace vibro_impact::paper {

// A window of the abscissa and a range of the ordinate, each with the distance between its printed
// ticks. The abscissa is time, Omega in Figure 3, and the time within a forcing period in Figure 4.
// The ordinate is a displacement, an impact velocity in Figure 3, and F2 in Figure 4.
struct AxisBox {
  double from, to;
  double lowest, highest;
  double tick_across, tick;
};

// The axes of a panel, as "figure2a". Throws std::runtime_error if the table has none of that name,
// or cannot be read.
inline AxisBox panel(const std::string &name) {
  static const auto panels = [] {
    const std::string table = REFERENCE_DIR "/panels.csv";
    std::map<std::string, AxisBox> boxes;
    for (const truth::Row &row : truth::read_rows(table))
      boxes[row.cell("panel")] = {row.number("from"),        row.number("to"),
                                  row.number("lowest"),      row.number("highest"),
                                  row.number("tick_across"), row.number("tick")};
    return boxes;
  }();
  const auto found = panels.find(name);
  if (found == panels.end()) throw std::runtime_error("panel '" + name + "': is not in panels.csv");
  return found->second;
}

}  // namespace vibro_impact::paper
