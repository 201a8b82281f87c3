#include "documents.hpp"

#include <fmt/format.h>

#include <regex>
#include <stdexcept>

namespace vibro_impact::figures {

namespace {

// The text with one blank for every sequence of blanks and line breaks.
std::string on_one_line(const std::string &text) {
  static const std::regex space(R"(\s+)");
  return std::regex_replace(text, space, " ");
}

// Whether nothing but a bullet stands before this place in its line.
bool begins_a_line(const std::string &text, std::size_t place) {
  const auto last = text.find_last_not_of(" -", place - 1);
  return place == 0 || last == std::string::npos || text[last] == '\n';
}

// The numbers with five or more decimals outside of code; an address may have four digits first.
std::vector<std::string> long_numbers(const std::string &text) {
  static const std::regex code("```[^`]*```"), number(R"(\b\d{1,3}\.\d{5,})");
  const std::string prose = std::regex_replace(text, code, "");
  std::vector<std::string> found;
  for (std::sregex_iterator word(prose.begin(), prose.end(), number), none; word != none; ++word)
    found.push_back(word->str());
  return found;
}

}  // namespace

Document renewed(const std::string &name, const std::string &text, const TextOf &text_of) {
  const std::string opening = "<!--=", opened = "-->", closing = "<!--/-->";
  Document document;
  std::string outside;
  const auto fault = [&](const std::string &fragment, const std::string &what) {
    document.faults.push_back(fmt::format("{}: {}: {}", name, fragment, what));
  };
  std::size_t done = 0;
  for (auto begin = text.find(opening); begin != std::string::npos;
       begin = text.find(opening, done)) {
    const auto shown_from = text.find(opened, begin) + opened.size(),
               shown_to = text.find(closing, begin);
    const std::string fragment =
        text.substr(begin + opening.size(), shown_from - opened.size() - begin - opening.size());
    if (shown_to == std::string::npos || text.find(opening, begin + 1) < shown_to) {
      fault(fragment, "has no end");
      break;
    }
    const std::string shown = text.substr(shown_from, shown_to - shown_from);
    if (!shown.starts_with('\n') && (begins_a_line(text, begin) || begins_a_line(text, shown_to)))
      fault(fragment, "begins a line");
    outside += text.substr(done, begin - done) + ' ';
    document.text += text.substr(done, shown_from - done);
    std::string right = shown;
    try {
      right = text_of(fragment);
    } catch (const std::exception &error) {
      fault(fragment, error.what());
    }
    const bool same = on_one_line(shown) == on_one_line(right);
    if (!same) fault(fragment, fmt::format("must be '{}', not '{}'", right, shown));
    document.text += same ? shown : right;
    done = shown_to;
  }
  document.text += text.substr(done);
  for (const std::string &number : long_numbers(outside + text.substr(done)))
    fault(number, "is in no fragment");
  return document;
}

}  // namespace vibro_impact::figures
