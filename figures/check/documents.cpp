#include "documents.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <regex>
#include <sstream>
#include <stdexcept>

namespace vibro_impact::figures {

namespace {

// The text that belongs to a name. Throws std::runtime_error for any other.
std::string text_of(const Results &results, const std::string &part) {
  if (part == "counts") return count_of_verdicts(results.findings);
  if (part == "published") return count_of_results(results.findings);
  if (part == "speed") return comparison::sentence_of_speed(results.measured);
  if (part == "methods") return "\n" + table_of(comparison::rows_of_methods(results.measured));
  const auto blank = part.find(' ');
  if (blank == std::string::npos)
    throw std::runtime_error("<!--check " + part + "-->: nothing of that name is computed");
  const std::string first = part.substr(0, blank), rest = part.substr(blank + 1);
  if (first == "few") return "\n" + table_of_few(results.findings, rest);
  if (first == "class") return name(number_of(results.findings, rest).verdict());
  return fmt::format(fmt::runtime("{:" + rest + "}"), number_of(results.findings, first).computed);
}

}  // namespace

std::string with_computed_parts(const Results &results, const std::string &document) {
  const std::string opening = "<!--check ", closing = "-->", ending = "<!--end-->";
  std::string text;
  std::size_t done = 0;
  for (auto begin = document.find(opening); begin != std::string::npos;
       begin = document.find(opening, done)) {
    const auto name = begin + opening.size(), close = document.find(closing, name),
               end = document.find(ending, name);
    if (close == std::string::npos || end == std::string::npos)
      throw std::runtime_error(document.substr(begin, 40) + ": has no end");
    text += document.substr(done, close + closing.size() - done);
    text += text_of(results, document.substr(name, close - name));
    done = end;
  }
  return text + document.substr(done);
}

namespace {

// True if a key number, rounded to as many digits as `word` has, is `word`.
bool is_a_key_number(const Results &results, const std::string &word) {
  const auto exponent = word.find('e');
  const auto decimals = std::min(exponent, word.size()) - word.find('.') - 1;
  for (const Finding &finding : results.findings) {
    if (!finding.number.of_the_paper()) continue;
    const double size = std::abs(finding.computed);
    const std::string rounded = exponent == std::string::npos
                                    ? fmt::format("{:.{}f}", size, decimals)
                                    : fmt::format("{:.{}e}", size, decimals);
    if (std::stod(rounded) == std::stod(word)) return true;
  }
  return false;
}

}  // namespace

std::vector<std::string> unknown_numbers(const Results &results, const std::string &document) {
  static const std::regex number(R"((^|[^\w./])(\d+\.\d+(e-?\d+)?)(?![\w/]))");
  std::vector<std::string> unknown;
  std::istringstream lines(document);
  bool code = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("```")) code = !code;
    if (code) continue;
    for (std::sregex_iterator word(line.begin(), line.end(), number), none; word != none; ++word) {
      const std::string digits = word->str(2).substr(0, word->str(2).find('e'));
      const auto first = digits.find_first_not_of("0.");
      const bool long_enough = first != std::string::npos &&
                               digits.size() - first - (first < digits.find('.') ? 1 : 0) >= 5;
      if (long_enough && !is_a_key_number(results, word->str(2))) unknown.push_back(word->str(2));
    }
  }
  return unknown;
}

}  // namespace vibro_impact::figures
