// Key numbers and published results with the values of the library, and their tables in Markdown.
#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "key_numbers.hpp"
#include "results_of_others.hpp"
#include "verdict.hpp"

namespace vibro_impact::figures {

struct CheckedNumber {
  KeyNumber number;
  double computed;

  double error() const {
    return std::abs(computed - number.reference);
  }
  bool pass() const {
    return error() <= number.tolerance;  // false for NaN
  }
  Verdict verdict() const {
    return number.printed.verdict(computed);
  }
};

// Throws std::runtime_error if a row has no function, or a function no row.
inline std::vector<CheckedNumber> checked_numbers(const std::string &folder) {
  const std::string table = folder + "/key_numbers.csv";
  std::vector<CheckedNumber> checked;
  for (const KeyNumber &number : read_key_numbers(table))
    checked.push_back({number, key_number(number.symbol)});
  const auto computable = key_number_functions().size() + paper::sticking_changes().size();
  if (checked.size() != computable)
    throw std::runtime_error(fmt::format("{}: has {} rows, but {} key numbers are computed", table,
                                         checked.size(), computable));
  return checked;
}

struct CheckedResult {
  published::Result result;
  double computed;

  bool pass() const {
    return std::abs(computed - result.value) <= result.tolerance;
  }
};

inline std::vector<CheckedResult> checked_results(const std::string &folder) {
  std::vector<CheckedResult> checked;
  for (const published::Result &result : published::results(folder))
    checked.push_back({result, result.compute()});
  return checked;
}

// A table of Markdown, every column as wide as its widest cell.
inline std::string table_of(const truth::Rows &rows) {
  std::vector<std::size_t> widths(rows.front().size());
  for (const auto &cells : rows)
    for (std::size_t k = 0; k < cells.size(); ++k) widths[k] = std::max(widths[k], cells[k].size());
  std::string text;
  for (const auto &cells : rows) {
    for (std::size_t k = 0; k < cells.size(); ++k)
      text += fmt::format("| {:<{}} ", cells[k], widths[k]);
    text += "|\n";
    if (&cells != &rows.front()) continue;
    for (const std::size_t width : widths) text += fmt::format("|{:-<{}}", "", width + 2);
    text += "|\n";
  }
  return text;
}

inline std::vector<CheckedNumber> with_verdict(const std::vector<CheckedNumber> &numbers,
                                               Verdict verdict) {
  std::vector<CheckedNumber> some;
  for (const CheckedNumber &checked : numbers)
    if (checked.verdict() == verdict) some.push_back(checked);
  return some;
}

// A table for every verdict, with the error of every number.
inline std::string tables_by_verdict(const std::vector<CheckedNumber> &numbers) {
  std::string text;
  for (const Verdict verdict : all_verdicts) {
    truth::Rows rows{{"number", "the paper says", "computed", "error", "allowed", "reference"}};
    for (const auto &checked : with_verdict(numbers, verdict))
      rows.push_back(
          {checked.number.meaning, checked.number.printed.words,
           checked.number.formatted(checked.computed), fmt::format("{:.1e}", checked.error()),
           fmt::format("{:.2g}", checked.number.tolerance) + (checked.pass() ? "" : " FAILS"),
           checked.number.kind});
    text += fmt::format("\n**{}: {}**\n\n{}", name(verdict), rows.size() - 1, table_of(rows));
  }
  return text;
}

// The key number of that symbol. Throws std::runtime_error if there is none.
inline const CheckedNumber &number_of(const std::vector<CheckedNumber> &numbers,
                                      const std::string &symbol) {
  for (const CheckedNumber &checked : numbers)
    if (checked.number.symbol == symbol) return checked;
  throw std::runtime_error("key number '" + symbol + "': the table has no such row");
}

// A table of the numbers with these symbols, which blanks separate.
inline std::string table_of_few(const std::vector<CheckedNumber> &numbers,
                                const std::string &symbols) {
  truth::Rows rows{{"number", "the paper", "here", "class"}};
  std::istringstream words(symbols);
  for (std::string symbol; words >> symbol;) {
    const auto &[number, computed] = number_of(numbers, symbol);
    rows.push_back({number.meaning, number.printed.words, number.formatted(computed),
                    name(number.printed.verdict(computed))});
  }
  return table_of(rows);
}

inline std::string table_of_results(const std::vector<CheckedResult> &results) {
  truth::Rows rows{{"id", "source", "quantity", "kind", "printed", "computed", "difference",
                    "allowed", "limited by", "verdict"}};
  for (const CheckedResult &checked : results) {
    const published::Result &result = checked.result;
    rows.push_back({result.id, result.source, result.quantity, result.kind, result.printed,
                    fmt::format("{:.15g}", checked.computed),
                    fmt::format("{:.1e}", checked.computed - result.value),
                    fmt::format("{:.0e}", result.tolerance), result.limited_by,
                    checked.pass() ? "pass" : "FAIL"});
  }
  return table_of(rows);
}

// The number of key numbers of every class, as the documents and the last line of `check` have it.
inline std::string count_of_verdicts(const std::vector<CheckedNumber> &numbers) {
  const auto count = [&](Verdict verdict) { return with_verdict(numbers, verdict).size(); };
  return fmt::format(
      "{} key numbers: {} agree with the paper, {} are close to it, {} differ from it, {} depend "
      "on "
      "an inferred value, {} are not in the paper",
      numbers.size(), count(Verdict::agrees), count(Verdict::close), count(Verdict::differs),
      count(Verdict::depends_on_an_inferred_value), count(Verdict::not_in_the_paper));
}

// The number of published results of every kind (reference/README.md).
inline std::string count_of_results(const std::vector<CheckedResult> &results) {
  const auto count = [&](const char *kind) {
    return std::count_if(results.begin(), results.end(), [kind](const CheckedResult &checked) {
      return checked.result.kind == kind;
    });
  };
  return fmt::format(
      "{} printed results of other authors, {} values of their formulas and {} numbers derived "
      "from "
      "formulas",
      count("printed"), count("formula"), count("derived"));
}

}  // namespace vibro_impact::figures
