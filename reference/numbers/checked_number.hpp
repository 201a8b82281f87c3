// The table of checked numbers: key numbers of the paper and results that others printed.
//
// A row has a quantity, its arguments and a reference: a value of a formula, of the 50-digit
// generator, or of another author. A key number also has the paper's words and the verdict on a
// computed number.
//
// The bounds of the values of which the paper's words are true follow from figures/README.md,
// Classes. A count must be equal. The statement that something happens holds for every count from
// one on.
#pragma once

#include <fmt/format.h>

#include <limits>
#include <string>
#include <vector>

#include "arguments.hpp"

namespace vibro_impact::numbers {

// The classes of figures/README.md. A claim that is no number may have the last three.
enum class Verdict {
  agrees,
  close,
  differs,
  depends_on_an_inferred_value,
  not_in_the_paper,
  agrees_otherwise,
  cannot_be_judged,
  rebuilt
};
constexpr const char *verdict_words[] = {
    "agrees",           "close",  "differs", "inferred", "not in the paper", "agrees otherwise",
    "cannot be judged", "rebuilt"};
inline const char *name(Verdict verdict) {
  return verdict_words[static_cast<int>(verdict)];
}

// How the paper has a number. The computed number rests on an inferred parameter where the paper's
// statement is about a figure whose parameters are not all printed.
enum class Claim : std::size_t { none, stated, read_off_figure_3, of_inferred_parameters };
constexpr const char *claim_words[] = {"", "stated", "read", "inferred"};

// The origin of a reference (reference/README.md).
enum class Kind : std::size_t { computed, formula, printed };
constexpr const char *kind_words[] = {"computed", "formula", "printed"};

// A number in a format of {fmt}, with the exponent as short as possible: 1e-6.
inline std::string formatted(double value, const std::string &format) {
  std::string text = fmt::format(fmt::runtime("{:" + format + "}"), value);
  const auto exponent = text.find("e-0");
  return exponent == std::string::npos ? text : text.erase(exponent + 2, 1);
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

// A row of reference/tables/checked_numbers.csv.
struct CheckedNumber {
  std::string id;
  std::string digits;  // of the reference, as the table has them
  double value = 0.0;  // of the reference
  Kind kind = Kind::computed;
  std::string source;    // wagg for a key number of the paper, or another author
  std::string quantity;  // what is computed, and from which arguments
  std::string given;     // the arguments, as the table has them
  Arguments arguments;
  std::string meaning;     // in words
  Printed printed;         // by the paper
  std::string format;      // of the computed number, as {fmt} has it
  double tolerance = 0.0;  // allowed distance from the reference, absolute
  std::string why;         // this tolerance; of another author's number, whose error it is

  bool of_the_paper() const {
    return source == "wagg";
  }
  std::string formatted(double computed) const {
    return numbers::formatted(computed, format);
  }
};

// All rows of checked_numbers.csv in a folder. Throws std::runtime_error naming the table and what
// is wrong with it.
inline std::vector<CheckedNumber> checked_numbers(const std::string &folder) {
  const std::string path = folder + "/checked_numbers.csv";
  std::vector<CheckedNumber> numbers;
  for (const truth::Row &row : truth::read_rows(path)) {
    const auto bound = [&](const std::string &column) {
      return row.cell(column).empty() ? std::numeric_limits<double>::infinity()
                                      : row.number(column);
    };
    const std::string &given = row.cell("arguments");
    numbers.push_back(
        {.id = row.cell("id"),
         .digits = row.cell("value"),
         .value = row.number("value"),
         .kind = Kind{truth::word_in(row.place(), row.cell("kind"), kind_words)},
         .source = row.cell("source"),
         .quantity = row.cell("quantity"),
         .given = given,
         .arguments = read_arguments(row.place(), given),
         .meaning = row.cell("meaning"),
         .printed = {row.cell("the_paper_says"),
                     Claim{truth::word_in(row.place(), row.cell("claim"), claim_words)},
                     bound("from"), bound("to")},
         .format = row.cell("format"),
         .tolerance = row.number("tolerance"),
         .why = row.cell("why")});
  }
  return numbers;
}

}  // namespace vibro_impact::numbers
