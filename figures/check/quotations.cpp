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

// The text of a document without its fragments, anchors and targets of links, on one line.
std::string text_to_check(const std::string &text) {
  std::string kept = without(text, R"(<!--=[^>]*-->[^]*?<!--/-->)");
  kept = without(kept, R"(<a id="[^"]*">)");
  kept = without(kept, R"(\]\([^)]*\))");
  return on_one_line(kept);
}

}  // namespace

std::vector<std::string> numbers_without_origin(const std::string &name, const std::string &text,
                                                const std::vector<std::string> &quotations) {
  std::vector<std::string> faults;
  std::string kept = text_to_check(text);
  std::string rest = kept;
  for (const std::string &words : quotations) {
    auto place = kept.find(words);
    if (place == std::string::npos)
      faults.push_back(fmt::format("{}: the quotation '{}' is not there", name, words));
    for (; place != std::string::npos; place = kept.find(words, place + words.size()))
      std::fill_n(rest.begin() + static_cast<std::ptrdiff_t>(place), words.size(), ' ');
  }
  static const std::regex number(R"([-+]?\d[\d.]*(e-?\d+)?|²|³|)"
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
