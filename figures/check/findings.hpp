// Checked numbers with the values of the library, and their table in Markdown.
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
  // The class of a key number (figures/README.md), and the origin of another author's number.
  std::string class_name() const {
    return number.of_the_paper() ? name(number.printed.verdict(computed))
                                 : numbers::kind_words[static_cast<std::size_t>(number.kind)];
  }
};

using Findings = std::vector<Finding>;

// All rows of the table in a folder. Throws std::runtime_error for a table that cannot be read.
Findings findings(const std::string &folder);

// A table of Markdown, every column as wide as its widest cell.
std::string table_of(const std::vector<truth::Cells> &rows);

// The table of all numbers.
std::string table_of(const Findings &findings);

// The number with that id. Throws std::runtime_error if there is none.
const Finding &number_of(const Findings &findings, const std::string &id);

}  // namespace vibro_impact::figures
