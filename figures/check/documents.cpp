#include "documents.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <regex>
#include <sstream>

namespace vibro_impact::figures {

namespace {

// The text with one blank for every sequence of blanks and line breaks.
std::string on_one_line(const std::string &text) {
  static const std::regex space(R"(\s+)");
  return std::regex_replace(text, space, " ");
}

// True if a key number, rounded to as many digits as `word` has, is `word`.
bool is_a_key_number(const Findings &findings, const std::string &word) {
  const auto exponent = word.find('e');
  const auto decimals = std::min(exponent, word.size()) - word.find('.') - 1;
  for (const Finding &finding : findings) {
    if (!finding.number.of_the_paper()) continue;
    const double size = std::abs(finding.computed);
    const std::string rounded = exponent == std::string::npos
                                    ? fmt::format("{:.{}f}", size, decimals)
                                    : fmt::format("{:.{}e}", size, decimals);
    if (std::stod(rounded) == std::stod(word)) return true;
  }
  return false;
}

// The numbers of five or more significant digits, outside code and links, that are no key number.
std::vector<std::string> unknown_numbers(const Findings &findings, const std::string &text) {
  static const std::regex number(R"((^|[^\w./])(\d+\.\d+(e-?\d+)?)(?![\w/]))");
  std::vector<std::string> unknown;
  std::istringstream lines(text);
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

}  // namespace

std::vector<std::string> faults_of(const Findings &findings, const Document &document,
                                   const std::string &text) {
  std::vector<std::string> faults;
  const std::string words = on_one_line(text);
  for (const std::string &quoted : document.quoted)
    if (words.find(on_one_line(quoted)) == std::string::npos)
      faults.push_back(document.name + ": must quote: " + quoted);
  static const std::regex verdict(R"re(\[([^\]]*)\]\([^)]*checked_numbers\.csv "([^"]*)"\))re");
  for (std::sregex_iterator link(text.begin(), text.end(), verdict), none; link != none; ++link) {
    const std::string right = name(number_of(findings, link->str(2)).verdict());
    if (link->str(1) != right)
      faults.push_back(fmt::format("{}: {}: must be '{}', not '{}'", document.name, link->str(2),
                                   right, link->str(1)));
  }
  if (!document.only_key_numbers) return faults;
  for (const std::string &word : unknown_numbers(findings, text))
    faults.push_back(fmt::format("{}: {} is no key number rounded", document.name, word));
  return faults;
}

}  // namespace vibro_impact::figures
