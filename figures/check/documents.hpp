// The parts of a document that are computed. In the text <!--check NAME-->...<!--end--> encloses
// the text that belongs to NAME: a table, a sentence with counts, the class of a key number, or its
// value. Outside, every number of five or more significant digits must be a key number, rounded to
// the digits shown.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <regex>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "checked_numbers.hpp"
#include "figures/error_vs_runtime/measured.hpp"

namespace vibro_impact::figures {

// The results of `make check`, for the documents.
struct Findings {
  std::vector<CheckedNumber> numbers;
  std::vector<CheckedResult> results;
  std::vector<comparison::Measured> measured = {};
};

// The text that belongs to a name: counts, published, speed, methods, "few" with symbols, "class"
// with a symbol, or a symbol with a format, as in "figure5b_nearest_gap .1e". Throws
// std::runtime_error for any other.
inline std::string text_of(const Findings &findings, const std::string &name) {
  if (name == "counts") return count_of_verdicts(findings.numbers);
  if (name == "published") return count_of_results(findings.results);
  if (name == "speed") return comparison::sentence_of_speed(findings.measured);
  if (name == "methods") return "\n" + table_of(comparison::rows_of_methods(findings.measured));
  const auto blank = name.find(' ');
  if (blank == std::string::npos)
    throw std::runtime_error("<!--check " + name + "-->: nothing of that name is computed");
  const std::string first = name.substr(0, blank), rest = name.substr(blank + 1);
  if (first == "few") return "\n" + table_of_few(findings.numbers, rest);
  if (first == "class") return figures::name(number_of(findings.numbers, rest).verdict());
  return fmt::format(fmt::runtime("{:" + rest + "}"), number_of(findings.numbers, first).computed);
}

// The document with its computed parts written anew. Throws std::runtime_error for a part without
// an end.
inline std::string with_computed_parts(const Findings &findings, const std::string &document) {
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
    text += text_of(findings, document.substr(name, close - name));
    done = end;
  }
  return text + document.substr(done);
}

// True if a key number, rounded to as many digits as `word` has, is `word`.
inline bool is_a_key_number(const Findings &findings, const std::string &word) {
  const auto exponent = word.find('e');
  const auto decimals = std::min(exponent, word.size()) - word.find('.') - 1;
  for (const CheckedNumber &checked : findings.numbers) {
    const double size = std::abs(checked.computed);
    const std::string rounded = exponent == std::string::npos
                                    ? fmt::format("{:.{}f}", size, decimals)
                                    : fmt::format("{:.{}e}", size, decimals);
    if (std::stod(rounded) == std::stod(word)) return true;
  }
  return false;
}

// The numbers of five or more significant digits, outside code and links, that are no key number.
inline std::vector<std::string> unknown_numbers(const Findings &findings,
                                                const std::string &document) {
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
      if (long_enough && !is_a_key_number(findings, word->str(2))) unknown.push_back(word->str(2));
    }
  }
  return unknown;
}

}  // namespace vibro_impact::figures
