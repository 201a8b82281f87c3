// The texts of the fragments of documents (documents.hpp) by their names:
//   border_mass_1_2:.5f            a key number in this format; without one, in that of its row
//   class:border_mass_1_2          its class
//   claim:agrees_otherwise:table1_test
//                                  the class of a claim without a key number, and a test that shows
//                                  it
//   count:border_mass_+jump_:w     how many key numbers begin with one of these, or are of such a
//                                  class
//   procedures_starts:0.62:settled_motions:.0f
//                                  the cell of a table in the folder of tables: of the first row
//                                  that begins with these cells, as 0.02,0.7,0, in this column
//   fits:5(a)                      the frequencies that fit a figure; the one that is drawn is bold
//   verdicts                       any name in `text_named` in fragments.cpp
// A format is one of {fmt}, or w for a word.
#pragma once

#include <string>
#include <vector>

#include "figures/error_vs_runtime/measured.hpp"
#include "findings.hpp"

namespace vibro_impact::figures {

// The computed numbers that documents quote.
struct Sources {
  Findings findings;
  std::vector<comparison::Measured> measured;
  std::string tables;  // the folder to which the drivers of the figures wrote
};

// Throws std::runtime_error for a name that means nothing, and naming a table that cannot be read.
std::string text_of(const std::string &fragment, const Sources &sources);

}  // namespace vibro_impact::figures
