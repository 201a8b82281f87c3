// Numbers of a document that nothing computes: quotations of the paper, definitions, dates. They
// stand in reference/tables/quotations.csv with the words around them, so that an edited number is
// seen.
#pragma once

#include <string>
#include <vector>

namespace vibro_impact::figures {

// A line for each number of a document, in digits or as a word from two to ten, that stands neither
// in a fragment nor in a quotation of it, and for each quotation that the document has not. Numbers
// in names (mass 1, Eq. 7, x1) and in blocks of code count. The targets of links do not.
std::vector<std::string> numbers_without_origin(const std::string &name, const std::string &text,
                                                const std::vector<std::string> &quotations);

// The quotations of a document in the table of a folder.
std::vector<std::string> quotations_of(const std::string &folder, const std::string &name);

}  // namespace vibro_impact::figures
