// Fragments of documents: texts that `check` writes and compares. Comments of Markdown stand around
// a fragment. The first one has its name, which says what the fragment shows:
//   from <!--=border_mass_1_2:.5f-->0.29654<!--/-->
// The names are
//   border_mass_1_2:.5f            a key number in this format; without one, in that of its row
//   class:border_mass_1_2          its class
//   claims:figure3                 the table of the claims of a section (claims.hpp)
//   count_of_claims:agrees+close   how many claims are of one of these classes; all: of any
//   count:border_mass_+formula     how many numbers begin with one of these, or are of such a class
//   procedures_windows:period 1 alone:from+to:.3f
//                                  the cells in these columns of a table in the folder of tables,
//                                  of all rows that begin with these cells, as 0.02,0.7
//   parameters, changes_of_sticking, procedures
//                                  tables of figures/README.md (page_tables.hpp)
//   steppers, methods              the tables of error against run time
//   grazing_speed                  the speed below which impacts are not compared
// A format is one of {fmt}.
#pragma once

#include <string>
#include <vector>

#include "claims.hpp"
#include "figures/measures/measured.hpp"
#include "findings.hpp"

namespace vibro_impact::figures {

// The computed numbers that documents quote.
struct Sources {
  Findings findings;
  std::vector<Claim> claims;
  std::vector<comparison::Measured> measured;
  std::string tables;  // the folder to which the drivers of the figures wrote
};

// Throws std::runtime_error for a name that means nothing, and naming a table that cannot be read.
std::string text_of(const std::string &fragment, const Sources &sources);

// A document with the right fragments, and a line for each fault that it had: a fragment with
// another text, without an end, of an unknown name or at the beginning of a line, which Markdown
// then takes for HTML. Line breaks and the number of blanks do not matter.
struct Document {
  std::string text;
  std::vector<std::string> faults;
};

Document renewed(const std::string &name, const std::string &text, const Sources &sources);

}  // namespace vibro_impact::figures
