// `make check`: every key number, held against its reference and against what the paper says of it,
// and every published result of others; the verdicts, counted, and one line in the end that says
// whether all passed. The key numbers also as the table of reference/README.md (--markdown) and,
// nine of them, of the README (--few).
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "driver.hpp"
#include "key_numbers.hpp"
#include "printed.hpp"
#include "published.hpp"
#include "reference/table_reader.hpp"

namespace {

using namespace vibro_impact;
using figures::Rows;
namespace column = figures::column;

// Six that the paper has, and three that one would cite.
constexpr std::array<std::string_view, 9> few{
    "lambda1",         "exit_slope",      "multi_sliding_mass_1",
    "border_mass_1_2", "border_mass_1_3", "border_mass_2_4",
    "border_mass_1_1", "DG_Omega",        "grazing_mass_2_figure5b"};

// By the word that a verdict begins with.
constexpr std::array<std::pair<std::string_view, std::string_view>, 3> verdicts{
    {{"agrees", "Agrees with the paper, within what its print or plot can tell"},
     {"differs", "Differs from the paper, by more than that"},
     {"not", "Not in the paper: library against 50 digits or a formula"}}};

constexpr const char *what_the_words_mean =
    "agrees: within half a unit of the last digit printed; between two ticks, where an axis ends; "
    "within a twentieth of the distance of the ticks, where a value is read off Figure 3\n"
    "error: against the reference (reference/README.md), rounding where it is below the last bit; "
    "allowed: more fails\n";

constexpr const char *what_the_others_mean =
    "id: the row of reference/published.csv, which has the parameters; source: "
    "reference/README.md; "
    "limited by: what keeps the two apart, ours, theirs, or both\n";

// The error of a double, which an error smaller than its last bit is not.
std::string shown_error(double error, double value, double tolerance) {
  if (tolerance == 0.0 && error == 0.0) return "none";
  const double last_bit = std::nextafter(std::abs(value), HUGE_VAL) - std::abs(value);
  return error < last_bit ? "rounding" : fmt::format("{:.1e}", error);
}

std::string shown_tolerance(double tolerance) {
  return tolerance == 0.0 ? "none" : fmt::format("{:.0e}", tolerance);
}

// Below the names of the columns, a row of them for every key number; `missed` gets the symbols of
// those that are farther from their reference than allowed.
Rows checked_key_numbers(const std::string &folder, std::vector<std::string> &missed) {
  // A number located with 50 digits takes precedence over the library's own of an earlier version.
  figures::References references;
  for (const char *table : {"key_numbers.csv", "located.csv", "bifurcation_points.csv"})
    references.merge(figures::read_references(folder + "/" + table));
  const auto functions = figures::key_numbers();
  Rows rows{{"symbol", "meaning", "printed", "computed", "kind", "digits", "error", "tolerance",
             "verdict", "reference_met"}};
  for (const auto &number : figures::read_key_numbers(folder + "/key_number_checks.csv")) {
    const auto reference = references.find(number.symbol);
    const auto function = functions.find(number.symbol);
    if (reference == references.end() || function == functions.end())
      throw std::runtime_error(number.symbol + ": has no reference, or is not computed here");
    const double computed = function->second(), value = reference->second.value,
                 error = std::abs(computed - value);
    const bool pass = error <= number.tolerance;  // false for NaN
    if (!pass) missed.push_back(number.symbol);
    rows.push_back({number.symbol, number.meaning, number.printed.words,
                    fmt::format(fmt::runtime("{:" + number.digits + "}"), computed),
                    reference->second.kind, reference->second.digits,
                    shown_error(error, value, number.tolerance), shown_tolerance(number.tolerance),
                    number.printed.verdict(computed), pass ? "pass" : "FAIL"});
  }
  return rows;
}

// The numbers with one verdict, below a header; how far from the paper is said where they differ.
Rows lines_of(const Rows &numbers, std::string_view verdict) {
  const bool differs = verdict == "differs";
  Rows lines{{"number", "the paper says", "computed"}};
  if (differs) lines.front().push_back("by");
  for (const char *name : {"error", "allowed", "reference", "its digits"})
    lines.front().push_back(name);
  for (const auto &row : numbers) {
    const std::string &words = row[column::verdict];
    if (!words.starts_with(verdict)) continue;
    lines.push_back({row[column::meaning], row[column::printed], row[column::computed]});
    auto &line = lines.back();
    if (differs) line.push_back(words.substr(words.rfind(' ') + 1));
    line.insert(line.end(), {row[column::error],
                             row[column::allowed] + (row[column::met] == "pass" ? "" : " FAILS"),
                             row[column::kind], row[column::digits]});
  }
  return lines;
}

// A table of Markdown, every column as wide as its widest cell.
void print_table(const Rows &rows) {
  std::vector<std::size_t> widths(rows.front().size());
  for (const auto &cells : rows)
    for (std::size_t k = 0; k < cells.size(); ++k) widths[k] = std::max(widths[k], cells[k].size());
  for (const auto &cells : rows) {
    for (std::size_t k = 0; k < cells.size(); ++k) fmt::print("| {:<{}} ", cells[k], widths[k]);
    fmt::print("|\n");
    if (&cells != &rows.front()) continue;
    for (const std::size_t width : widths) fmt::print("|{:-<{}}", "", width + 2);
    fmt::print("|\n");
  }
}

// A table for every verdict, without the last columns.
void print_key_numbers(const Rows &rows, std::size_t without) {
  for (const auto &[verdict, title] : verdicts) {
    Rows lines = lines_of(rows, verdict);
    for (auto &cells : lines) cells.resize(cells.size() - without);
    fmt::print("\n**{}: {}**\n\n", title, lines.size() - 1);
    print_table(lines);
  }
}

void print_few(const Rows &numbers) {
  Rows lines{{"number", "the paper says", "computed", "verdict"}};
  for (const std::string_view symbol : few)
    for (const auto &row : numbers)
      if (row[column::symbol] == symbol)
        lines.push_back({row[column::meaning], row[column::printed], row[column::computed],
                         row[column::verdict]});
  print_table(lines);
}

// Every published result beside what the library makes of it; `missed` gets those that are farther
// from what was printed than their tolerance.
Rows checked_published_results(const std::vector<published::Result> &results,
                               std::vector<std::string> &missed) {
  Rows lines{{"id", "source", "quantity", "printed", "computed", "difference", "allowed",
              "limited by", "verdict"}};
  for (const auto &result : results) {
    const double computed = result.compute(), difference = computed - result.value;
    const bool pass = std::abs(difference) <= result.tolerance;  // false for NaN
    if (!pass) missed.push_back(result.id);
    lines.push_back({result.id, result.source, result.quantity, result.printed,
                     fmt::format("{:.15g}", computed), fmt::format("{:.1e}", difference),
                     fmt::format("{:.0e}", result.tolerance), result.limited_by,
                     pass ? "pass" : "FAIL"});
  }
  return lines;
}

// As a table of the report, every cell in quotes.
void write_cells(const Rows &lines, const std::string &path) {
  Table table("");
  table.text.clear();
  for (const auto &cells : lines) table.text += fmt::format("\"{}\"\n", fmt::join(cells, "\",\""));
  write(table, path);
}

// The last line, and the exit status: 1 when anything is missed.
int conclude(const Rows &numbers, std::size_t published, const std::vector<std::string> &missed) {
  const auto count = [&](std::string_view verdict) {
    return lines_of(numbers, verdict).size() - 1;
  };
  const std::string counts = fmt::format(
      "{} key numbers ({} agree with the paper, {} differ from it, {} are not in it) and {} "
      "published results",
      numbers.size() - 1, count("agrees"), count("differs"), count("not"), published);
  if (missed.empty())
    fmt::print("\nall passed: {}, each within what is allowed of its reference\n", counts);
  else
    fmt::print("\nFAILED: of {}, {} miss their reference: {}\n", counts, missed.size(),
               fmt::join(missed, ", "));
  return missed.empty() ? 0 : 1;
}

}  // namespace

int main(int argc, char **argv) {
  std::string folder = "reference", tables;
  bool markdown = false, nine = false;
  return figures::command(
      argc, argv, "Computes every key number and every published result and compares them",
      {{"--reference", "Folder of the tables of references", &folder},
       {"--markdown", "Print the table of reference/README.md", &markdown},
       {"--few", "Print the table of the README", &nine},
       {"--tables", "Folder for the rows as tables", &tables}},
      [&] {
        std::vector<std::string> missed;
        const Rows rows = checked_key_numbers(folder, missed);
        if (markdown) print_key_numbers(rows, 0);
        if (nine) print_few(rows);
        if (markdown || nine) return 0;
        fmt::print("{}", what_the_words_mean);
        print_key_numbers(rows, 2);  // the references and their digits
        fmt::print("\n**Published by others**\n\n{}\n", what_the_others_mean);
        const Rows published = checked_published_results(published::results(folder), missed);
        print_table(published);
        if (!tables.empty()) {
          write_cells(rows, tables + "/key_numbers_checked.csv");
          write_cells(published, tables + "/published_checked.csv");
        }
        return conclude(rows, published.size() - 1, missed);
      });
}
