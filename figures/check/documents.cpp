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

}  // namespace

Document renewed(const std::string &name, const std::string &text, const TextOf &text_of) {
  const std::string opening = "<!--=", opened = "-->", closing = "<!--/-->";
  Document document;
  std::size_t done = 0;
  for (auto begin = text.find(opening); begin != std::string::npos;
       begin = text.find(opening, done)) {
    const auto named = begin + opening.size(), from = text.find(opened, named) + opened.size(),
               to = text.find(closing, from);
    const std::string fragment = text.substr(named, from - opened.size() - named);
    const auto fault = [&](const std::string &what) {
      document.faults.push_back(fmt::format("{}: {}: {}", name, fragment, what));
    };
    if (to == std::string::npos || text.find(opening, named) < to) {
      fault("has no end");
      break;
    }
    const std::string shown = text.substr(from, to - from);
    if (!shown.starts_with('\n') && (begins_a_line(text, begin) || begins_a_line(text, to)))
      fault("begins a line");
    std::string right = shown;
    try {
      right = text_of(fragment);
    } catch (const std::exception &error) {
      fault(error.what());
    }
    const bool same = on_one_line(shown) == on_one_line(right);
    if (!same) fault(fmt::format("must be '{}', not '{}'", right, shown));
    document.text += text.substr(done, from - done) + (same ? shown : right);
    done = to;
  }
  document.text += text.substr(done);
  return document;
}

}  // namespace vibro_impact::figures
