// The tables of a fresh run against those stored in the repository: byte for byte by their SHA-256,
// and number by number in the rows of which the repository keeps a copy.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace vibro_impact::figures {

// The file name of a table or picture -> its SHA-256, as `sha256sum` prints and checks it.
struct Sums {
  std::string platform;  // what decides the last bits of a result
  std::map<std::string, std::string> of;
};

// The sums of all tables (.csv) and pictures (.png) of a folder, by coreutils' sha256sum. Throws
// std::runtime_error when that fails.
Sums sums_of(const std::filesystem::path &folder, const std::string &platform);
Sums read_sums(const std::filesystem::path &file);
std::string text_of(const Sums &sums);

// Some rows of a table, evenly spread, with their numbers (from 0) in the whole one.
struct Extract {
  std::string header;
  std::vector<std::size_t> numbers = {};
  std::vector<std::vector<std::string>> rows = {};
  std::size_t rows_in_all = 0;
};

// At most `most` rows, the first and the last among them, of those whose first cell is at most
// `until`.
Extract extract(const std::filesystem::path &table, std::size_t most, double until);
Extract read_extract(const std::filesystem::path &file);
std::string text_of(const Extract &extract);

// How the numbers of a table may differ between platforms: by `tolerance` times the largest modulus
// in their column, where the first column is at most `until`. Not compared at all: `not compared`
// in place of a number.
struct Rule {
  double tolerance = 0.0, until = 0.0;
  bool compared = true;
  std::string reason;
};

// The rules by the beginning of a table's name; the longest that fits applies.
using Rules = std::map<std::string, Rule>;
Rules read_rules(const std::filesystem::path &file);
const Rule &rule_for(const Rules &rules, const std::string &table);

// The largest difference of two extracts relative to the largest modulus in its column, or why they
// cannot be compared. A column `error` holds estimates, most at the level of rounding: they are
// compared relative to 1, the order of the numbers they belong to.
struct Difference {
  double largest = 0.0;
  std::string where = {};   // the row and column of the largest
  std::string reason = {};  // not empty: another header, number of rows or text
};
Difference difference(const Extract &fresh, const Extract &stored);

}  // namespace vibro_impact::figures
