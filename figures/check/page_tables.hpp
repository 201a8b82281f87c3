// Tables of figures/README.md in Markdown.
#pragma once

#include <string>
#include <vector>

#include "findings.hpp"
#include "reference/truth/table_reader.hpp"

namespace vibro_impact::figures {

// A table with cells as wide as their texts.
std::string narrow_table(const std::vector<truth::Cells> &rows);

// The stops, the restitution, the frequency and the window of each figure. What is inferred stands
// in italics.
std::string table_of_parameters();

// The frequencies at which the sticking phases of a mass change, by what happens there.
std::string table_of_changes(const Findings &findings);

// Figures 3, 4 and 5(c) by each procedure, from the tables of the driver in a folder. In Figure
// 5(c) mass 2 never sticks, or does so once Omega or r is lower. Throws std::runtime_error for
// another outcome.
std::string table_of_procedures(const std::string &tables);

}  // namespace vibro_impact::figures
