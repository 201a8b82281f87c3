// Checked numbers with the values of the library, and their tables in Markdown.
#pragma once

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "reference/numbers/checked_number.hpp"

namespace vibro_impact::figures {

// A row with the library's value, which is NaN if it cannot be computed.
struct Finding {
  numbers::CheckedNumber number;
  double computed = std::numeric_limits<double>::quiet_NaN();
  std::string failure = {};  // why it cannot be computed

  double error() const {
    return std::abs(computed - number.value);
  }
  bool pass() const {
    return error() <= number.tolerance;  // false for NaN
  }
  numbers::Verdict verdict() const {
    return number.printed.verdict(computed);
  }
  // Whether this is a key number of that class.
  bool has(numbers::Verdict asked) const {
    return number.of_the_paper() && verdict() == asked;
  }
};

using Findings = std::vector<Finding>;

// All rows of the table in a folder. Throws std::runtime_error for a table that cannot be read.
Findings findings(const std::string &folder);

// A table of Markdown, every column as wide as its widest cell.
std::string table_of(const truth::Rows &rows);

// A table of the key numbers for every verdict, and one of the results of other authors.
std::string tables_of(const Findings &findings);

// The number with that id. Throws std::runtime_error if there is none.
const Finding &number_of(const Findings &findings, const std::string &id);

// How many key numbers have each verdict, and how many results of others are of each kind
// (reference/README.md), as the documents and the last line of `check` have it.
std::string count_of_verdicts(const Findings &findings);
std::string count_of_results(const Findings &findings);

}  // namespace vibro_impact::figures
