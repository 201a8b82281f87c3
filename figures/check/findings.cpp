#include "findings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "library_engine.hpp"

namespace vibro_impact::figures {

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

std::string table_of(const std::vector<truth::Cells> &rows) {
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

std::string table_of(const Findings &findings) {
  std::vector<truth::Cells> rows{{"number", "class", "printed", "computed", "error", "allowed"}};
  for (const Finding &finding : findings) {
    const numbers::CheckedNumber &number = finding.number;
    const bool other = !number.of_the_paper();
    rows.push_back(
        {other ? number.id : number.meaning, finding.class_name(),
         other ? number.digits : number.printed.words, number.formatted(finding.computed),
         numbers::formatted(finding.error(), ".1e"),
         numbers::formatted(number.tolerance, ".2g") + (finding.pass() ? "" : " FAILS")});
  }
  return table_of(rows);
}

const Finding &number_of(const Findings &findings, const std::string &id) {
  for (const Finding &finding : findings)
    if (finding.number.id == id) return finding;
  throw std::runtime_error("checked number '" + id + "': the table has no such row");
}

}  // namespace vibro_impact::figures
