// What the paper's print can tell of a number, and the verdict on it that follows.
//
// A decimal number is known to half a unit of its last digit, and a value that the text or the
// ticks of an axis put between two, to these. A frequency that the text reads off Figure 3, whose
// ticks stand 0.05 apart, is known to a twentieth of that: half a millimetre on the page can still
// be told. A count, or a mass that touches its stop, leaves no room; a statement that something
// happens holds for every count of it from one on.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "reference/table_reader.hpp"

namespace vibro_impact::figures {

// The paper's words, and the values that what they state cannot be told from. No words: the paper
// does not have the number.
struct Printed {
  std::string words = {};
  double from = 0.0, to = 0.0;

  // The verdict on what is computed; a number that differs, by how much from what is printed.
  std::string verdict(double computed) const {
    if (words.empty()) return "not in the paper";
    if (computed >= from && computed <= to) return "agrees with the paper";
    if (std::isinf(to)) return "differs from the paper: never";
    return fmt::format("differs from the paper by {:+.2g}", computed - 0.5 * (from + to));
  }
};

// The columns of key_numbers_checked.csv, a number each.
namespace column {
enum : std::size_t {
  symbol,
  meaning,
  printed,
  computed,
  kind,
  digits,
  error,
  allowed,
  verdict,
  met
};
}  // namespace column

// A row of reference/key_number_checks.csv, the last column of which says why that tolerance.
struct KeyNumber {
  std::string symbol, meaning;
  Printed printed;
  std::string digits;  // how many to show, as a format
  double tolerance;    // absolute
};

// Throws std::runtime_error naming the table and what is wrong with it.
inline std::vector<KeyNumber> read_key_numbers(const std::string &path) {
  std::vector<KeyNumber> numbers;
  for (const auto &cells : read_rows(path, 8)) {
    const auto bound = [&](const std::string &cell) {
      return cell.empty() ? std::numeric_limits<double>::infinity() : number_in(path, cell);
    };
    numbers.push_back({cells[0],
                       cells[1],
                       {cells[2], bound(cells[3]), bound(cells[4])},
                       cells[5],
                       number_in(path, cells[6])});
  }
  return numbers;
}

}  // namespace vibro_impact::figures
