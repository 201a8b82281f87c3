// The claims of the paper (reference/tables/claims.csv), each with its words, what is found here,
// its class, and what decides the class: a key number, or a test.
#pragma once

#include <string>
#include <vector>

#include "findings.hpp"

namespace vibro_impact::figures {

struct Claim {
  std::string section;  // of figures/README.md: model, figure2, ...
  std::string place;    // in the paper
  std::string words;    // of the paper
  std::string ours;     // with the names of fragments in braces: to {border_mass_1_3:.5f}
  std::string verdict;  // the class (figures/README.md)
  std::string decider;  // the id of a key number, or the file and the name of a test: a_test.Name
};

// All rows of the table in a folder. Throws std::runtime_error naming the table and what is wrong
// with it: a class that is none, a decider that is not there, or a key number of another class.
std::vector<Claim> claims(const std::string &folder, const Findings &findings);

// The class of a claim, with the file of the test that decides it.
std::string class_of(const Claim &claim);

// How many claims are of one of some classes, which are joined by + and have underlines for blanks.
// All of them for "all".
std::ptrdiff_t count_of_claims(const std::vector<Claim> &claims, const std::string &classes);

}  // namespace vibro_impact::figures
