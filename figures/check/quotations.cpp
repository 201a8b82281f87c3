#include "quotations.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <regex>

#include "reference/truth/table_reader.hpp"
#include "words.hpp"

namespace vibro_impact::figures {

namespace {

std::string without(const std::string &text, const char *expression) {
  return std::regex_replace(text, std::regex(expression), " ");
}

// The prose of a document: no fragments, code, anchors and targets of links.
std::string prose_of(const std::string &text) {
  std::string prose = without(text, R"(<!--=[^>]*-->[^]*?<!--/-->)");
  prose = without(prose, R"(```[^]*?```)");
  prose = without(prose, R"(<a id="[^"]*">)");
  prose = without(prose, R"(\]\([^)]*\))");
  prose = without(prose, R"(\n    [^\n]*)");
  return on_one_line(without(prose, R"(`[^`]*`)"));
}

// Names with numbers: Figures 2 and 4(a), Eqs. 17-18, mass 1, Section 3.2, Table 1.
const char *const name_with_number =
    R"(\b(Figures?|Eqs?\.|mass|masses)\s\d{1,2}(\([a-c]\))?(?!\.?\d))"
    R"((( and | to |, |-)\d{1,2}(\([a-c]\))?(?!\.?\d))*|\bSections? \d\.\d(?!\d))";

}  // namespace

std::vector<std::string> numbers_without_origin(const std::string &name, const std::string &text,
                                                const std::vector<std::string> &quotations) {
  std::vector<std::string> faults;
  std::string prose = prose_of(text);
  std::string rest = prose;
  for (const std::string &words : quotations) {
    auto place = prose.find(words);
    if (place == std::string::npos)
      faults.push_back(fmt::format("{}: the quotation '{}' is not there", name, words));
    for (; place != std::string::npos; place = prose.find(words, place + words.size()))
      std::fill_n(rest.begin() + static_cast<std::ptrdiff_t>(place), words.size(), ' ');
  }
  rest = without(rest, name_with_number);
  static const std::regex number(R"((^|[^A-Za-z0-9_.])[-+]?\d[\d.]*(e-?\d+)?|)"
                                 R"(\b([Tt]wo|[Tt]hree|[Ff]our|[Ff]ive|[Ss]ix|[Ss]even|[Ee]ight|)"
                                 R"([Nn]ine|[Tt]en)\b)");
  for (std::sregex_iterator found(rest.begin(), rest.end(), number), end; found != end; ++found) {
    const auto place = static_cast<std::size_t>(found->position());
    faults.push_back(fmt::format("{}: '{}' is neither computed nor in the list of quotations: {}",
                                 name, found->str(), rest.substr(place < 30 ? 0 : place - 30, 60)));
  }
  return faults;
}

std::vector<std::string> quotations_of(const std::string &folder, const std::string &name) {
  std::vector<std::string> words;
  for (const truth::Row &row : truth::read_rows(folder + "/quotations.csv"))
    if (row.cell("document") == name) words.push_back(row.cell("words"));
  return words;
}

}  // namespace vibro_impact::figures
