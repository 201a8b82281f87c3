// The table of key numbers, what the paper says of each, and the verdict on a computed number.
//
// A printed decimal number is known to half a unit of its last digit. An extreme of a plot is known
// to lie between the two ticks where the printed axis ends. A count must be equal. The statement
// that something happens holds for every count from one on.
//
// The text reads the edges of two windows off Figure 3 ("0.3 <~ Omega <~ 0.35"). The readings have
// two decimals. A computed edge is close to a reading if it is that number to two decimals.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "reference/truth/table_reader.hpp"

namespace vibro_impact::figures {

enum class Verdict { agrees, close, differs, depends_on_an_inferred_value, not_in_the_paper };
constexpr Verdict all_verdicts[] = {Verdict::agrees, Verdict::close, Verdict::differs,
                                    Verdict::depends_on_an_inferred_value,
                                    Verdict::not_in_the_paper};

inline const char *name(Verdict verdict) {
  constexpr const char *names[] = {"agrees", "close", "differs", "depends on an inferred value",
                                   "not in the paper"};
  return names[static_cast<int>(verdict)];
}

// How the paper has a number. The computed number rests on an inferred parameter where the paper's
// statement is about a figure whose parameters are not all printed.
enum class Claim { none, stated, read_off_figure_3, of_inferred_parameters };

// Throws std::runtime_error naming the table for any other text.
inline Claim claim_in(const std::string &path, const std::string &cell) {
  if (cell.empty()) return Claim::none;
  if (cell == "stated") return Claim::stated;
  if (cell == "read") return Claim::read_off_figure_3;
  if (cell == "inferred") return Claim::of_inferred_parameters;
  throw std::runtime_error(path + ": '" + cell + "' is no kind of claim");
}

// The paper's words, and the values of which these words are true.
struct Printed {
  std::string words = {};
  Claim claim = Claim::none;
  double from = 0.0, to = 0.0;

  Verdict verdict(double computed) const {
    if (claim == Claim::none) return Verdict::not_in_the_paper;
    if (claim == Claim::of_inferred_parameters) return Verdict::depends_on_an_inferred_value;
    if (!(computed >= from && computed <= to)) return Verdict::differs;
    return claim == Claim::read_off_figure_3 ? Verdict::close : Verdict::agrees;
  }
};

// A row of reference/tables/key_numbers.csv.
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
  for (const auto &cells : truth::read_rows(path, 11)) {
    const auto bound = [&](const std::string &cell) {
      return cell.empty() ? std::numeric_limits<double>::infinity() : truth::number_in(path, cell);
    };
    numbers.push_back(
        {.symbol = cells[0],
         .meaning = cells[3],
         .printed = {cells[4], claim_in(path, cells[5]), bound(cells[6]), bound(cells[7])},
         .reference = truth::number_in(path, cells[1]),
         .reference_digits = cells[1],
         .kind = cells[2],
         .format = cells[8],
         .tolerance = truth::number_in(path, cells[9])});
  }
  return numbers;
}

}  // namespace vibro_impact::figures
