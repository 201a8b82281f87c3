#include "claims.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "words.hpp"

namespace vibro_impact::figures {

namespace {

// Whether a file in tests, named in front of the dot, has the test named behind it.
bool is_test(const std::string &named) {
  const std::vector<std::string> test = split(named, '.');
  if (test.size() != 2) return false;
  const std::filesystem::directory_iterator folders(SOURCE_DIR "/tests");
  return std::ranges::any_of(folders, [&](const std::filesystem::path &folder) {
    std::ostringstream text;
    text << std::ifstream(folder / (test[0] + ".cpp")).rdbuf();
    return text.str().find(", " + test[1] + ") {") != std::string::npos;
  });
}

// The fault of a claim; empty if it has none.
std::string fault_of(const Claim &claim, const Findings &findings) {
  if (claim.decider.find('.') != std::string::npos)
    return is_test(claim.decider) ? "" : "there is no test " + claim.decider;
  const std::string computed = number_of(findings, claim.decider).class_name();
  return computed == claim.verdict ? ""
                                   : fmt::format("{} is of the class '{}', not '{}'", claim.decider,
                                                 computed, claim.verdict);
}

}  // namespace

std::vector<Claim> claims(const std::string &folder, const Findings &findings) {
  std::vector<Claim> claims;
  for (const truth::Row &row : truth::read_rows(folder + "/claims.csv")) {
    const Claim claim{row.cell("section"), row.cell("place"), row.cell("the_paper"),
                      row.cell("ours"),    row.cell("class"), row.cell("decided_by")};
    truth::word_in(row.place(), claim.verdict, numbers::verdict_words);
    const std::string fault = fault_of(claim, findings);
    if (!fault.empty()) throw std::runtime_error(fmt::format("{}: {}", row.place(), fault));
    claims.push_back(claim);
  }
  return claims;
}

std::string class_of(const Claim &claim) {
  const auto dot = claim.decider.find('.');
  return dot == std::string::npos
             ? claim.verdict
             : fmt::format("{} (`{}`)", claim.verdict, claim.decider.substr(0, dot));
}

std::ptrdiff_t count_of_claims(const std::vector<Claim> &claims, const std::string &classes) {
  const std::vector<std::string> words = split(with_blanks(classes), '+');
  return std::ranges::count_if(claims, [&](const Claim &claim) {
    return classes == "all" || std::ranges::find(words, claim.verdict) != words.end();
  });
}

}  // namespace vibro_impact::figures
