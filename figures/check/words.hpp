// Parts of texts.
#pragma once

#include <algorithm>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

namespace vibro_impact::figures {

inline std::vector<std::string> split(const std::string &text, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
  return parts;
}

// Words of a class, with blanks in place of underlines.
inline std::string with_blanks(std::string words) {
  std::ranges::replace(words, '_', ' ');
  return words;
}

// The text with one blank for every sequence of blanks and line breaks.
inline std::string on_one_line(const std::string &text) {
  static const std::regex space(R"(\s+)");
  return std::regex_replace(text, space, " ");
}

}  // namespace vibro_impact::figures
