#include "findings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "library_engine.hpp"

namespace vibro_impact::figures {

using numbers::Verdict;

Findings findings(const std::string &folder) {
  Findings findings;
  for (const auto &number : numbers::checked_numbers(folder)) {
    findings.push_back({number});
    try {
      findings.back().computed = computed(number);
    } catch (const std::exception &error) {
      findings.back().failure = error.what();
    }
  }
  return findings;
}

std::string table_of(const truth::Rows &rows) {
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

std::string tables_of(const Findings &findings) {
  std::string text;
  const auto add = [&](const char *heading, const auto &belongs) {
    truth::Rows rows{{"number", "printed", "computed", "error", "allowed", "reference"}};
    for (const Finding &finding : findings) {
      if (!belongs(finding)) continue;
      const numbers::CheckedNumber &number = finding.number;
      const bool other = !number.of_the_paper();
      rows.push_back(
          {other ? number.id : number.meaning, other ? number.digits : number.printed.words,
           number.formatted(finding.computed), numbers::formatted(finding.error(), ".1e"),
           numbers::formatted(number.tolerance, ".2g") + (finding.pass() ? "" : " FAILS"),
           numbers::kind_words[static_cast<std::size_t>(number.kind)]});
    }
    text += fmt::format("\n**{}: {}**\n\n{}", heading, rows.size() - 1, table_of(rows));
  };
  for (const Verdict verdict : numbers::all_verdicts)
    add(name(verdict), [verdict](const Finding &finding) { return finding.has(verdict); });
  add("published by others", [](const Finding &finding) { return !finding.number.of_the_paper(); });
  return text;
}

const Finding &number_of(const Findings &findings, const std::string &id) {
  for (const Finding &finding : findings)
    if (finding.number.id == id) return finding;
  throw std::runtime_error("checked number '" + id + "': the table has no such row");
}

std::string count_of_verdicts(const Findings &findings) {
  std::size_t all = 0, algebra = 0, with[std::size(numbers::verdict_words)] = {};
  for (const Finding &finding : findings) {
    if (!finding.number.of_the_paper()) continue;
    ++all;
    ++with[static_cast<std::size_t>(finding.verdict())];
    algebra += finding.has(Verdict::agrees) && finding.number.kind == numbers::Kind::derived;
  }
  return fmt::format(
      "{} key numbers. Of these, {} agree with the paper ({} by algebra), {} are "
      "close to it, {} differ from it, {} depend on an inferred value, and {} are not in the paper",
      all, with[0], algebra, with[1], with[2], with[3], with[4]);
}

std::string count_of_results(const Findings &findings) {
  std::size_t of[std::size(numbers::kind_words)] = {};
  for (const Finding &finding : findings)
    of[static_cast<std::size_t>(finding.number.kind)] += !finding.number.of_the_paper();
  return fmt::format(
      "{} printed results of other authors, {} values of their formulas and {} numbers derived "
      "from formulas",
      of[3], of[2], of[1]);
}

}  // namespace vibro_impact::figures
