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

namespace {

Findings with_verdict(const Findings &findings, Verdict verdict) {
  Findings some;
  for (const Finding &finding : findings)
    if (finding.number.of_the_paper() && finding.verdict() == verdict) some.push_back(finding);
  return some;
}

}  // namespace

std::string tables_of(const Findings &findings) {
  std::string text;
  const auto add = [&](const char *heading, const Findings &some) {
    truth::Rows rows{{"number", "printed", "computed", "error", "allowed", "reference"}};
    for (const Finding &finding : some) {
      const numbers::CheckedNumber &number = finding.number;
      const bool other = !number.of_the_paper();
      rows.push_back({other ? number.id : number.meaning,
                      other ? number.digits : number.printed.words,
                      number.formatted(finding.computed), fmt::format("{:.1e}", finding.error()),
                      fmt::format("{:.2g}", number.tolerance) + (finding.pass() ? "" : " FAILS"),
                      number.kind});
    }
    text += fmt::format("\n**{}: {}**\n\n{}", heading, some.size(), table_of(rows));
  };
  for (const Verdict verdict : numbers::all_verdicts)
    add(name(verdict), with_verdict(findings, verdict));
  Findings others;
  for (const Finding &finding : findings)
    if (!finding.number.of_the_paper()) others.push_back(finding);
  add("published by others", others);
  return text;
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
  const auto count = [&](Verdict verdict) { return with_verdict(findings, verdict).size(); };
  std::size_t all = 0, algebra = 0, of_figure4 = 0;
  for (const Verdict verdict : numbers::all_verdicts) all += count(verdict);
  for (const Finding &finding : with_verdict(findings, Verdict::agrees)) {
    if (finding.number.kind == "derived") ++algebra;
    if (finding.number.meaning.starts_with("Figure 4")) ++of_figure4;
  }
  return fmt::format(
      "{} key numbers. Of these, {} agree with the paper ({} by algebra, {} in Figure 4), {} are "
      "close to it, {} differ from it, {} depend on an inferred value, and {} are not in the paper",
      all, count(Verdict::agrees), algebra, of_figure4, count(Verdict::close),
      count(Verdict::differs), count(Verdict::depends_on_an_inferred_value),
      count(Verdict::not_in_the_paper));
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
