// `make check`: every key number of the paper, computed and held against its reference, and every
// published result of others; one row each, and a verdict. With --markdown the key numbers as the
// table of the README.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <string>
#include <utility>

#include "driver.hpp"
#include "key_bifurcations.hpp"
#include "key_numbers.hpp"
#include "published_results.hpp"
#include "table_reader.hpp"

namespace {

using namespace vibro_impact;

std::string shown(const std::string &format, double value) {
  return fmt::format(fmt::runtime(format), value);
}

// The reference as its table has it, if that is the generator's with all its digits: a count or a
// number of the library has fewer.
std::string thirty_digits(const figures::Reference &reference) {
  const std::string mantissa = reference.digits.substr(0, reference.digits.find('e'));
  const auto digits =
      std::count_if(mantissa.begin(), mantissa.end(), [](char c) { return c >= '0' && c <= '9'; });
  return digits >= 28 ? reference.digits : "";  // trailing zeros are not written
}

// Exit status: 1 when a number misses its reference.
int check_key_numbers(const std::string &folder, bool markdown) {
  // A number located with 50 digits takes precedence over the library's own of an earlier version.
  figures::References references;
  for (const char *table : {"key_numbers.csv", "located.csv", "bifurcation_points.csv"})
    references.merge(figures::read_references(folder + "/" + table));
  auto numbers = figures::key_numbers();
  for (auto &number : figures::key_bifurcations()) numbers.push_back(std::move(number));
  int failed = 0;
  if (markdown)
    fmt::print(
        "| number | paper | computed | error | tolerance | kind of the reference | its thirty "
        "digits "
        "|\n|---|---|---|---|---|---|---|\n");
  else
    fmt::print("{:<30} {:<22} {:<11} {:>22} {:>10} {:>9}  verdict\n", "symbol", "paper", "kind",
               "computed", "error", "tolerance");
  for (const auto &number : numbers) {
    const figures::Reference &reference = references.at(number.symbol);
    const double computed = number.compute(), error = std::abs(computed - reference.value);
    const bool pass = error <= number.tolerance;  // false for NaN
    if (!pass) ++failed;
    if (markdown)
      fmt::print("| {} | {} | {} | {:.1e} | {:.0e} | {} | {} |\n", number.meaning, number.printed,
                 shown(number.decimals, computed), error, number.tolerance, reference.kind,
                 thirty_digits(reference));
    else
      fmt::print("{:<30} {:<22} {:<11} {:>22} {:>10.1e} {:>9.0e}  {}\n", number.symbol,
                 number.printed, reference.kind, shown(number.decimals, computed), error,
                 number.tolerance, pass ? "pass" : "FAIL");
  }
  if (failed == 0) return 0;
  std::fflush(stdout);
  fmt::print(stderr, "check: {} of the key numbers miss their reference\n", failed);
  return 1;
}

// Exit status: 1 when a result is farther from what was printed than its tolerance.
int check_published_results(const std::string &folder) {
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
  std::string folder = "reference";
  bool markdown = false;
  return figures::command(
      argc, argv, "Computes every key number and every published result and compares them",
      {{"--reference", "Folder of the tables of references", &folder},
       {"--markdown", "Print the table of the README", &markdown}},
      [&] {
        const int status = check_key_numbers(folder, markdown);
        return markdown ? status : std::max(status, check_published_results(folder));
      });
}
