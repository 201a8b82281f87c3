// The table of key numbers, what the paper's print can tell of a number, and the verdict on a
// computed number that follows.
//
// A printed decimal number is known to half a unit of its last digit. An extreme of a plot is known
// to lie between the two ticks where the printed axis ends. A frequency that the text reads off
// Figure 3, whose ticks stand 0.05 apart, is known to a twentieth of that distance, which is half a
// millimetre on the page. A count, or a mass that touches its stop, leaves no room. The statement
// that something happens holds for every count from one on.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "reference/table_reader.hpp"

namespace vibro_impact::figures {

enum class Verdict { agrees, differs, not_in_the_paper };

// The paper's words, and the interval of values that these words cannot be told from. Without words
// the paper does not have the number.
struct Printed {
  std::string words = {};
  double from = 0.0, to = 0.0;

  Verdict verdict(double computed) const {
    if (words.empty()) return Verdict::not_in_the_paper;
    return computed >= from && computed <= to ? Verdict::agrees : Verdict::differs;
  }

  // How far a number that differs lies from the middle of the interval.
  std::string difference(double computed) const {
    return std::isinf(to) ? "never" : fmt::format("{:+.2g}", computed - 0.5 * (from + to));
  }

  std::string sentence(double computed) const {
    const Verdict result = verdict(computed);
    if (result == Verdict::agrees) return "agrees with the paper";
    if (result == Verdict::not_in_the_paper) return "not in the paper";
    return std::isinf(to) ? "differs from the paper: never"
                          : "differs from the paper by " + difference(computed);
  }
};

// A row of reference/key_numbers.csv.
struct KeyNumber {
  std::string symbol, meaning;
  Printed printed;
  double reference;              // the value of the reference
  std::string reference_digits;  // its digits in the table
  std::string kind;              // derived (from a formula) or computed (to 50 digits)
  std::string format;            // of the computed number, as {fmt} has it
  double tolerance;              // allowed distance from the reference, absolute

  std::string formatted(double value) const {
    return fmt::format(fmt::runtime("{:" + format + "}"), value);
  }
};

// Throws std::runtime_error naming the table and what is wrong with it.
inline std::vector<KeyNumber> read_key_numbers(const std::string &path) {
  std::vector<KeyNumber> numbers;
  for (const auto &cells : read_rows(path, 10)) {
    const auto bound = [&](const std::string &cell) {
      return cell.empty() ? std::numeric_limits<double>::infinity() : number_in(path, cell);
    };
    numbers.push_back({.symbol = cells[0],
                       .meaning = cells[3],
                       .printed = {cells[4], bound(cells[5]), bound(cells[6])},
                       .reference = number_in(path, cells[1]),
                       .reference_digits = cells[1],
                       .kind = cells[2],
                       .format = cells[7],
                       .tolerance = number_in(path, cells[8])});
  }
  return numbers;
}

}  // namespace vibro_impact::figures
