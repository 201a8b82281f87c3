// Checked numbers with the values of the library, and their tables in Markdown.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "reference/numbers/checked_number.hpp"

namespace vibro_impact::figures {

// A row with the library's value.
struct Finding {
  numbers::CheckedNumber number;
  double computed;

  double error() const {
    return std::abs(computed - number.value);
  }
  bool pass() const {
    return error() <= number.tolerance;  // false for NaN
  }
  numbers::Verdict verdict() const {
    return number.printed.verdict(computed);
  }
};

using Findings = std::vector<Finding>;

// All rows of the table in a folder. Throws std::runtime_error naming a row that cannot be
// computed.
Findings findings(const std::string &folder);

// A table of Markdown, every column as wide as its widest cell.
std::string table_of(const truth::Rows &rows);

// A table of the key numbers for every verdict, with the error of each.
std::string tables_by_verdict(const Findings &findings);

// A table of the results of other authors.
std::string table_of_results(const Findings &findings);

// The number with that id. Throws std::runtime_error if there is none.
const Finding &number_of(const Findings &findings, const std::string &id);

// A table of the numbers with these ids.
std::string table_of_few(const Findings &findings, const std::vector<std::string> &ids);

// How many key numbers have each verdict, and how many results of others are of each kind
// (reference/README.md), as the documents and the last line of `check` have it.
std::string count_of_verdicts(const Findings &findings);
std::string count_of_results(const Findings &findings);

}  // namespace vibro_impact::figures
