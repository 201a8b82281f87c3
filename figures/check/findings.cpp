#include "findings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "library_engine.hpp"

namespace vibro_impact::figures {

using numbers::Verdict;

Findings findings(const std::string &folder) {
  Findings findings;
  for (const auto &number : numbers::checked_numbers(folder))
    findings.push_back({number, computed(number)});
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

namespace {

Findings with_verdict(const Findings &findings, Verdict verdict) {
  Findings some;
  for (const Finding &finding : findings)
    if (finding.number.of_the_paper() && finding.verdict() == verdict) some.push_back(finding);
  return some;
}

}  // namespace

std::string tables_by_verdict(const Findings &findings) {
  std::string text;
  for (const Verdict verdict : numbers::all_verdicts) {
    truth::Rows rows{{"number", "the paper says", "computed", "error", "allowed", "reference"}};
    for (const Finding &finding : with_verdict(findings, verdict)) {
      const numbers::CheckedNumber &number = finding.number;
      rows.push_back({number.meaning, number.printed.words, number.formatted(finding.computed),
                      fmt::format("{:.1e}", finding.error()),
                      fmt::format("{:.2g}", number.tolerance) + (finding.pass() ? "" : " FAILS"),
                      number.kind});
    }
    text += fmt::format("\n**{}: {}**\n\n{}", name(verdict), rows.size() - 1, table_of(rows));
  }
  return text;
}

std::string table_of_results(const Findings &findings) {
  truth::Rows rows{{"id", "source", "quantity", "kind", "printed", "computed", "difference",
                    "allowed", "limited by", "verdict"}};
  for (const Finding &finding : findings) {
    const numbers::CheckedNumber &number = finding.number;
    if (number.of_the_paper()) continue;
    rows.push_back(
        {number.id, number.source, number.quantity, number.kind, number.digits,
         number.formatted(finding.computed), fmt::format("{:.1e}", finding.computed - number.value),
         fmt::format("{:.0e}", number.tolerance), number.why, finding.pass() ? "pass" : "FAIL"});
  }
  return table_of(rows);
}

const Finding &number_of(const Findings &findings, const std::string &id) {
  for (const Finding &finding : findings)
    if (finding.number.id == id) return finding;
  throw std::runtime_error("checked number '" + id + "': the table has no such row");
}

std::string table_of_few(const Findings &findings, const std::vector<std::string> &ids) {
  truth::Rows rows{{"number", "the paper", "here", "class"}};
  for (const std::string &id : ids) {
    const Finding &finding = number_of(findings, id);
    rows.push_back({finding.number.meaning, finding.number.printed.words,
                    finding.number.formatted(finding.computed), name(finding.verdict())});
  }
  return table_of(rows);
}

std::string count_of_verdicts(const Findings &findings) {
  std::vector<std::size_t> counts;
  std::size_t all = 0;
  for (const Verdict verdict : numbers::all_verdicts) {
    counts.push_back(with_verdict(findings, verdict).size());
    all += counts.back();
  }
  return fmt::format(
      "{} key numbers: {} agree with the paper, {} are close to it, {} differ from it, {} depend "
      "on an inferred value, {} are not in the paper",
      all, counts[0], counts[1], counts[2], counts[3], counts[4]);
}

std::string count_of_results(const Findings &findings) {
  const auto count = [&](const char *kind) {
    return std::count_if(findings.begin(), findings.end(), [kind](const Finding &finding) {
      return !finding.number.of_the_paper() && finding.number.kind == kind;
    });
  };
  return fmt::format(
      "{} printed results of other authors, {} values of their formulas and {} numbers derived "
      "from formulas",
      count("printed"), count("formula"), count("derived"));
}

}  // namespace vibro_impact::figures
