#include "misspelt.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace vibro_impact::runner {

namespace {

// How many letters must be put in, left out or changed; upper and lower case are the same.
std::size_t distance(const std::string &one, const std::string &two) {
  const auto same = [](char a, char b) {
    return std::tolower(static_cast<unsigned char>(a)) ==
           std::tolower(static_cast<unsigned char>(b));
  };
  std::vector<std::size_t> row(two.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < one.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i + 1);
    for (std::size_t j = 0; j < two.size(); ++j) {
      const std::size_t changed = diagonal + (same(one[i], two[j]) ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({changed, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

// "; did you mean ...?" for a word near to one of these, or the beginning of one.
std::string suggestion(const std::string &word, const std::vector<std::string> &known) {
  std::string nearest;
  std::size_t least = 3;
  for (const std::string &other : known) {
    const bool begun = word.size() > 3 && other.starts_with(word);
    const std::size_t away = begun ? 1 : distance(word, other);
    if (away >= least || away >= word.size()) continue;
    least = away;
    nearest = other;
  }
  return nearest.empty() ? "" : fmt::format("; did you mean {}?", nearest);
}

}  // namespace

std::string explain(const CLI::App &app, const CLI::ParseError &error) {
  std::vector<std::string> commands, options;
  const CLI::App *command = nullptr;
  for (const CLI::App *one : app.get_subcommands(nullptr)) {
    commands.push_back(one->get_name());
    if (one->parsed()) command = one;
  }
  const std::vector<std::string> extra = app.remaining(true);
  if (command == nullptr) {
    const std::string rule = fmt::format("a command is needed: {}; see vibro-impact --help",
                                         fmt::join(commands, " or "));
    if (extra.empty()) return rule;
    const std::string near = suggestion(extra.front(), commands);
    return fmt::format("{}: {}", extra.front(), near.empty() ? rule : "no command" + near);
  }
  if (dynamic_cast<const CLI::ExtrasError *>(&error) == nullptr || extra.empty())
    return error.what();
  // The first option is at fault rather than the value that came with it.
  const auto option = std::find_if(extra.begin(), extra.end(),
                                   [](const std::string &word) { return word.starts_with("-"); });
  if (option == extra.end()) return fmt::format("{}: not expected here", extra.front());
  const std::string word = option->substr(0, option->find('='));
  for (const CLI::Option *known : command->get_options())
    options.push_back(known->get_name(false, false));
  return fmt::format("{}: no such option{}", word, suggestion(word, options));
}

}  // namespace vibro_impact::runner
