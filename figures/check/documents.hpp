// The parts of a document that are computed. In the text <!--check NAME-->...<!--end--> encloses
// the text that belongs to NAME: a table, a sentence with counts, the class of a key number, or its
// value. Outside, every number of five or more significant digits must be a key number, rounded to
// the digits shown.
#pragma once

#include <string>
#include <vector>

#include "figures/error_vs_runtime/measured.hpp"
#include "findings.hpp"

namespace vibro_impact::figures {

// The findings of `make check`, for the documents.
struct Results {
  Findings findings;
  std::vector<comparison::Measured> measured = {};
};

// The document with its computed parts written anew: counts, published, speed, methods, "few" with
// ids, "class" with an id, or an id with a format, as in "figure5b_nearest_gap .1e". Throws
// std::runtime_error for a part of another name, or without an end.
std::string with_computed_parts(const Results &results, const std::string &document);

// The numbers of five or more significant digits, outside code and links, that are no key number.
std::vector<std::string> unknown_numbers(const Results &results, const std::string &document);

}  // namespace vibro_impact::figures
