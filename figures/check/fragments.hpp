// What the fragments of documents show (documents.hpp), by their names:
//   border_mass_1_2:.5f            a key number in this format; without one, in that of its row
//   class:border_mass_1_2          its class
//   claim:border_orbits            the class of a claim without a key number, and the test of it
//   count:border_mass_:w           how many key numbers begin with this, or are of this class
//   procedures_starts:0.62:settled_motions:.0f
//                                  the cell of a table in the folder of tables: of the first row
//                                  that begins with these cells, as 0.02,0.7,0, in this column
//   fits:5(a)                      the frequencies that fit a figure; the one that is drawn is bold
//   verdicts                       any name in the list of texts in fragments.cpp
// A format is one of {fmt}, or w for a word, up to ten.
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

// A claim of the paper that no key number shows. The test is the name of a file in tests.
struct Claim {
  std::string name;
  numbers::Verdict verdict;
  std::string test;
};

const std::vector<Claim> &claims();

// Throws std::runtime_error for a name that means nothing, and naming a table that cannot be read.
std::string text_of(const std::string &fragment, const Sources &sources);

}  // namespace vibro_impact::figures
