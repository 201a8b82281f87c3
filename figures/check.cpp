// `make check`: every key number of the paper, computed and held against its reference, and every
// published result of others; one row each, and a verdict. The key numbers also as the tables of
// reference/README.md (--markdown) and, a dozen of them, of the README (--few).
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "driver.hpp"
#include "key_bifurcations.hpp"
#include "key_numbers.hpp"
#include "published_results.hpp"
#include "table_reader.hpp"

namespace {

using namespace vibro_impact;

// The dozen.
constexpr std::array<std::string_view, 12> few{"lambda1",
                                               "lambda2",
                                               "exit_slope",
                                               "figure2b_chatter_end",
                                               "multi_sliding_mass_1",
                                               "border_mass_1_1",
                                               "multi_sliding_mass_2",
                                               "border_mass_1_2",
                                               "border_mass_2_4",
                                               "grazing_mass_2_figure5b",
                                               "figure5c_release_time",
                                               "figure5c_bounce_interval"};

// One number checked, as it is shown.
struct Row {
  figures::KeyNumber number;
  std::string computed, kind;
  std::string thirty_digits;  // of the reference, where the generator has them
  double error = 0.0;
  bool pass = false;
};

// All digits of a reference, if they are the generator's: a count or a number of the library has
// fewer.
std::string thirty_digits(const figures::Reference &reference) {
  const std::string mantissa = reference.digits.substr(0, reference.digits.find('e'));
  const auto digits =
      std::count_if(mantissa.begin(), mantissa.end(), [](char c) { return c >= '0' && c <= '9'; });
  return digits >= 28 ? reference.digits : "";  // trailing zeros are not written
}

std::vector<Row> checked_key_numbers(const std::string &folder) {
  // A number located with 50 digits takes precedence over the library's own of an earlier version.
  figures::References references;
  for (const char *table : {"key_numbers.csv", "located.csv", "bifurcation_points.csv"})
    references.merge(figures::read_references(folder + "/" + table));
  auto numbers = figures::key_numbers();
  for (auto &number : figures::key_bifurcations()) numbers.push_back(std::move(number));
  std::vector<Row> rows;
  for (const auto &number : numbers) {
    const figures::Reference &reference = references.at(number.symbol);
    const double computed = number.compute(), error = std::abs(computed - reference.value);
    const bool pass = error <= number.tolerance;  // false for NaN
    const std::string shown = fmt::format(fmt::runtime(number.decimals), computed);
    rows.push_back({number, shown, reference.kind, thirty_digits(reference), error, pass});
  }
  return rows;
}

void print_text(const std::vector<Row> &rows) {
  fmt::print("{:<30} {:<22} {:<11} {:>22} {:>10} {:>9}  verdict\n", "symbol", "paper", "kind",
             "computed", "error", "tolerance");
  for (const Row &row : rows)
    fmt::print("{:<30} {:<22} {:<11} {:>22} {:>10.1e} {:>9.0e}  {}\n", row.number.symbol,
               row.number.printed, row.kind, row.computed, row.error, row.number.tolerance,
               row.pass ? "pass" : "FAIL");
}

void print_markdown(const std::vector<Row> &rows) {
  fmt::print(
      "| number | paper | computed | error | tolerance | kind of the reference | its thirty digits "
      "|\n|---|---|---|---|---|---|---|\n");
  for (const Row &row : rows)
    fmt::print("| {} | {} | {} | {:.1e} | {:.0e} | {} | {} |\n", row.number.meaning,
               row.number.printed, row.computed, row.error, row.number.tolerance, row.kind,
               row.thirty_digits);
}

void print_few(const std::vector<Row> &rows) {
  fmt::print(
      "| number | paper | reference, to thirty digits where they are known | error |\n"
      "|---|---|---|---|\n");
  for (const Row &row : rows)
    if (std::find(few.begin(), few.end(), row.number.symbol) != few.end())
      fmt::print("| {} | {} | {} | {:.1e} |\n", row.number.meaning, row.number.printed,
                 row.thirty_digits.empty() ? row.computed : row.thirty_digits, row.error);
}

Table table_of(const std::vector<Row> &rows) {
  Table table("symbol,meaning,printed,computed,kind,thirty_digits,error,tolerance,verdict");
  for (const Row &row : rows)
    table.row(row.number.symbol, figures::in_quotes(row.number.meaning),
              figures::in_quotes(row.number.printed), row.computed, row.kind, row.thirty_digits,
              fmt::format("{:.1e}", row.error), fmt::format("{:.0e}", row.number.tolerance),
              row.pass ? "pass" : "FAIL");
  return table;
}

// Exit status: 1 when a number misses its reference.
int missed(const std::vector<Row> &rows) {
  const auto failed = std::count_if(rows.begin(), rows.end(), [](const Row &r) { return !r.pass; });
  if (failed == 0) return 0;
  std::fflush(stdout);
  fmt::print(stderr, "check: {} of the key numbers miss their reference\n", failed);
  return 1;
}

// Exit status: 1 when a result is farther from what was printed than its tolerance. The rows go to
// `table` as well.
int check_published_results(const std::string &folder, Table &table) {
  const auto results = figures::published_results(folder);
  fmt::print("\n{:<32} {:>23} {:>20} {:>10} {:>9}  {}\n", "published elsewhere", "printed",
             "computed", "difference", "tolerance", "limited by");
  int failed = 0;
  std::map<std::string, int> counts;
  for (const auto &result : results) {
    const double computed = result.compute(), difference = computed - result.value;
    const bool pass = std::abs(difference) <= result.tolerance;  // false for NaN
    if (!pass) ++failed;
    ++counts[result.source];
    table.row(result.id, result.source, result.printed, fmt::format("{:.15g}", computed),
              fmt::format("{:.1e}", difference), fmt::format("{:.0e}", result.tolerance),
              figures::in_quotes(result.limited_by), pass ? "pass" : "FAIL");
    fmt::print("{:<32} {:>23} {:>20.15g} {:>10.1e} {:>9.0e}  {}\n", result.id, result.printed,
               computed, difference, result.tolerance, pass ? result.limited_by : "FAIL");
  }
  fmt::print("{} published results:", results.size());
  for (const auto &[source, count] : counts) fmt::print(" {} {}", source, count);
  fmt::print("\n");
  if (failed == 0) return 0;
  std::fflush(stdout);
  fmt::print(stderr, "check: {} of the published results are missed\n", failed);
  return 1;
}

}  // namespace

int main(int argc, char **argv) {
  std::string folder = "reference", tables;
  bool markdown = false, dozen = false;
  return figures::command(
      argc, argv, "Computes every key number and every published result and compares them",
      {{"--reference", "Folder of the tables of references", &folder},
       {"--markdown", "Print the table of reference/README.md", &markdown},
       {"--few", "Print the table of the README", &dozen},
       {"--tables", "Folder for the rows as tables", &tables}},
      [&] {
        const std::vector<Row> rows = checked_key_numbers(folder);
        const int status = missed(rows);
        if (markdown) print_markdown(rows);
        if (dozen) print_few(rows);
        if (markdown || dozen) return status;
        print_text(rows);
        Table published("id,source,printed,computed,difference,tolerance,limited_by,verdict");
        const int others = check_published_results(folder, published);
        if (!tables.empty()) {
          write(table_of(rows), tables + "/key_numbers_checked.csv");
          write(published, tables + "/published_checked.csv");
        }
        return std::max(status, others);
      });
}
