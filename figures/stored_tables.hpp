// How a table of a fresh run is held against the one stored in the repository, which keeps a few of
// its rows: number by number, by Debian's numdiff.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <string>

#include "platform.hpp"
#include "reference/table_reader.hpp"

namespace vibro_impact::figures {

// How the numbers of a table may differ between platforms: by `tolerance` times their size, near
// zero by a tenth of it, where the first column is at most `until`. No tolerance: the table is not
// compared.
struct Rule {
  std::optional<double> tolerance = {};
  double until = std::numeric_limits<double>::infinity();
};

// The rules by the beginning of a table's name; the longest that fits applies.
using Rules = std::map<std::string, Rule>;

inline Rules read_rules(const std::filesystem::path &path) {
  Rules rules;
  for (const auto &cells : read_rows(path.string(), 4)) {
    Rule &rule = rules[cells[0]];
    if (cells[1] != "not compared") rule.tolerance = number_in(path.string(), cells[1]);
    if (!cells[2].empty()) rule.until = number_in(path.string(), cells[2]);
  }
  return rules;
}

inline const Rule &rule_for(const Rules &rules, const std::string &table) {
  for (std::size_t length = table.size() + 1; length-- > 0;)
    if (const auto found = rules.find(table.substr(0, length)); found != rules.end())
      return found->second;
  throw std::runtime_error(table + ": no rule says how it is compared");
}

// At most `most` rows of a table as they stand there, evenly spread, the first and the last among
// them, each after its number (from 0); in front of them the header after the number of all rows.
// The table ends for this purpose where its first cell is above `until`.
inline std::string extract(const std::filesystem::path &table, double until,
                           std::size_t most = 41) {
  std::ifstream file = opened(table.string());
  std::string header;
  std::getline(file, header);
  std::vector<std::string> rows;
  for (std::string line; std::getline(file, line); rows.push_back(line)) {
    const auto value = as_number(line.substr(0, line.find(',')));
    if (value && *value > until) break;
  }
  std::string text = fmt::format("row of {},{}\n", rows.size(), header);
  const std::size_t kept = std::min(most, rows.size());
  for (std::size_t k = 0; k < kept; ++k) {
    const std::size_t number = kept == 1 ? 0 : k * (rows.size() - 1) / (kept - 1);
    text += fmt::format("{},{}\n", number, rows[number]);
  }
  return text;
}

// Why an extract is not the stored one within `tolerance`: what numdiff says; nothing when it is.
inline std::string difference(const std::string &extract, const std::filesystem::path &stored,
                              double tolerance) {
  const auto fresh = std::filesystem::temp_directory_path() /
                     fmt::format("{}.{}", getpid(), stored.filename().string());
  std::ofstream(fresh) << extract;
  const std::string said =
      output_of(fmt::format("numdiff -s ',\\n' -a {} -r {} '{}' '{}' 2>&1", 0.1 * tolerance,
                            tolerance, fresh.string(), stored.string()));
  std::filesystem::remove(fresh);
  return said.find("are equal") != std::string::npos ? "" : said;
}

}  // namespace vibro_impact::figures
