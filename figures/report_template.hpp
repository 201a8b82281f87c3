// A text with places to be filled from tables: `{{verb argument ...}}`, arguments with spaces in
// double quotes. What the report says in numbers is looked up, none of it typed.
#pragma once

#include <functional>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace vibro_impact::figures {

// A table as header and rows of cells, quotes taken off.
struct Sheet {
  std::string name;
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows = {};

  // The index of a column. Throws std::runtime_error naming both.
  std::size_t column(const std::string &name_of_it) const {
    for (std::size_t k = 0; k < columns.size(); ++k)
      if (columns[k] == name_of_it) return k;
    throw std::runtime_error(name + ": no column " + name_of_it);
  }
  // The row whose first cell is `key`. Throws std::runtime_error naming both.
  const std::vector<std::string> &row(const std::string &key) const {
    for (const auto &cells : rows)
      if (cells[0] == key) return cells;
    throw std::runtime_error(name + ": no row " + key);
  }
};

using Arguments = std::vector<std::string>;
using Verbs = std::map<std::string, std::function<std::string(const Arguments &)>>;

// The words of a place: split at blanks, but for those in double quotes.
inline Arguments words_of(const std::string &place) {
  Arguments words;
  bool quoted = false, open = false;
  for (const char c : place) {
    if (c == '"') {
      quoted = !quoted;
      if (!open) words.emplace_back();
      open = true;
    } else if ((c == ' ' || c == '\n') && !quoted) {
      open = false;
    } else {
      if (!open) words.emplace_back();
      open = true;
      words.back() += c;
    }
  }
  return words;
}

// The text with every place filled. Throws std::runtime_error naming a place that has no verb, or
// whose verb fails.
inline std::string filled(const std::string &text, const Verbs &verbs) {
  std::string result;
  std::size_t at = 0;
  for (;;) {
    const std::size_t begin = text.find("{{", at);
    result += text.substr(at, begin - at);
    if (begin == std::string::npos) return result;
    const std::size_t end = text.find("}}", begin);
    if (end == std::string::npos)
      throw std::runtime_error("{{ without }}: " + text.substr(begin, 40));
    const std::string place = text.substr(begin + 2, end - begin - 2);
    Arguments words = words_of(place);
    if (words.empty() || !verbs.contains(words[0]))
      throw std::runtime_error("{{" + place + "}}: no such verb");
    const std::string verb = words[0];
    words.erase(words.begin());
    try {
      result += verbs.at(verb)(words);
    } catch (const std::exception &error) {
      throw std::runtime_error("{{" + place + "}}: " + error.what());
    }
    at = end + 2;
  }
}

// Text as it stands in HTML.
inline std::string escaped(const std::string &text) {
  std::string result;
  for (const char c : text) {
    if (c == '<')
      result += "&lt;";
    else if (c == '>')
      result += "&gt;";
    else if (c == '&')
      result += "&amp;";
    else if (c == '"')
      result += "&quot;";
    else
      result += c;
  }
  return result;
}

}  // namespace vibro_impact::figures
