// Key numbers and published results beside what the library computes, and their tables in Markdown.
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
#include "printed.hpp"
#include "published.hpp"

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
inline std::string table_of(const Rows &rows) {
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

// A table for every verdict. The last digits of an error are rounding, which no document repeats:
// with errors only where they are printed.
inline std::string tables_by_verdict(const std::vector<CheckedNumber> &numbers, bool with_errors) {
  std::string text;
  const auto add = [&](Verdict verdict, std::string_view title) {
    const std::vector<CheckedNumber> some = with_verdict(numbers, verdict);
    const bool differs = verdict == Verdict::differs;
    Rows rows{{"number", "the paper says", "computed"}};
    if (differs) rows[0].push_back("by");
    if (with_errors) rows[0].push_back("error");
    for (const char *name : {"allowed", "reference", "its digits"}) rows[0].push_back(name);
    for (const CheckedNumber &checked : some) {
      const KeyNumber &number = checked.number;
      auto &row = rows.emplace_back();
      row = {number.meaning, number.printed.words, number.formatted(checked.computed)};
      if (differs) row.push_back(number.printed.difference(checked.computed));
      if (with_errors) row.push_back(fmt::format("{:.1e}", checked.error()));
      row.push_back(fmt::format("{:.2g}", number.tolerance) + (checked.pass() ? "" : " FAILS"));
      row.push_back(number.kind);
      row.push_back(number.reference_digits);
    }
    text += fmt::format("\n**{}: {}**\n\n{}", title, some.size(), table_of(rows));
  };
  add(Verdict::agrees, "Agrees with the paper, within what its print or plot can tell");
  add(Verdict::differs, "Differs from the paper, by more than that");
  add(Verdict::not_in_the_paper, "Not in the paper: library against 50 digits or a formula");
  return text;
}

// The numbers of these symbols, which stand with blanks between them.
inline std::string table_of_few(const std::vector<CheckedNumber> &numbers,
                                const std::string &symbols) {
  Rows rows{{"number", "the paper says", "computed", "verdict"}};
  std::istringstream words(symbols);
  for (std::string symbol; words >> symbol;)
    for (const auto &[number, computed] : numbers)
      if (number.symbol == symbol)
        rows.push_back({number.meaning, number.printed.words, number.formatted(computed),
                        number.printed.sentence(computed)});
  return table_of(rows);
}

inline std::string table_of_results(const std::vector<CheckedResult> &results) {
  Rows rows{{"id", "source", "quantity", "kind", "printed", "computed", "difference", "allowed",
             "limited by", "verdict"}};
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

// "42 key numbers: 20 agree with the paper, ..." as the documents and the last line have it.
inline std::string count_of_verdicts(const std::vector<CheckedNumber> &numbers) {
  const auto count = [&](Verdict verdict) { return with_verdict(numbers, verdict).size(); };
  return fmt::format("{} key numbers: {} agree with the paper, {} differ from it, {} are not in it",
                     numbers.size(), count(Verdict::agrees), count(Verdict::differs),
                     count(Verdict::not_in_the_paper));
}

inline std::string count_of_results(const std::vector<CheckedResult> &results) {
  const auto derived =
      std::count_if(results.begin(), results.end(),
                    [](const CheckedResult &checked) { return checked.result.kind == "derived"; });
  return fmt::format("{} published results and {} limits derived for published scenes",
                     static_cast<std::ptrdiff_t>(results.size()) - derived, derived);
}

}  // namespace vibro_impact::figures
