// Documents that quote what `make check` computes. Each quotes some texts word for word: counts,
// sentences, tables. A link to checked_numbers.csv whose title is the id of a key number shows the
// verdict of that number:
//   [agrees](../reference/tables/checked_numbers.csv "lambda1")
// In the documents about the paper, every number of five or more significant digits is a key
// number, rounded to the digits shown.
#pragma once

#include <string>
#include <vector>

#include "findings.hpp"

namespace vibro_impact::figures {

struct Document {
  std::string name;
  std::vector<std::string> quoted;
  bool only_key_numbers;
};

// The faults of a document with this text, a line for each: a text that it does not quote, a
// verdict that is another one, a number that is no key number. Line breaks and the number of blanks
// do not matter. Throws std::runtime_error for a verdict of a number that the table lacks.
std::vector<std::string> faults_of(const Findings &findings, const Document &document,
                                   const std::string &text);

}  // namespace vibro_impact::figures
