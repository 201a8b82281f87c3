// `make check`: every key number of the paper, computed and held against its reference; one row
// each, and a verdict. With --markdown the same rows as the table of the README.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <fstream>
#include <map>

#include "key_numbers.hpp"

namespace {

struct Reference {
  double value;
  std::string kind;
};

// symbol -> value and kind, from the first three columns of the table.
std::map<std::string, Reference> read_references(const std::string &path) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error(path + ": cannot be read");
  std::map<std::string, Reference> table;
  std::string line;
  std::getline(file, line);
  while (std::getline(file, line)) {
    const std::size_t first = line.find(','), second = line.find(',', first + 1),
                      third = line.find(',', second + 1);
    if (third == std::string::npos) throw std::runtime_error(path + ": a row has too few columns");
    table[line.substr(0, first)] = {std::stod(line.substr(first + 1, second - first - 1)),
                                    line.substr(second + 1, third - second - 1)};
  }
  return table;
}

std::string shown(const std::string &format, double value) {
  return fmt::format(fmt::runtime(format), value);
}

}  // namespace

int main(int argc, char **argv) {
  std::string path = "reference/key_numbers.csv";
  bool markdown = false;
  CLI::App options("Computes every key number and compares it with its reference", "check");
  options.add_option("--reference", path, "Table of references")->capture_default_str();
  options.add_flag("--markdown", markdown, "Print the table of the README");
  CLI11_PARSE(options, argc, argv);
  try {
    const auto references = read_references(path);
    int failed = 0;
    if (markdown)
      fmt::print(
          "| number | paper | computed | error | tolerance | kind of the reference "
          "|\n|---|---|---|---|---|---|\n");
    else
      fmt::print("{:<30} {:<22} {:<11} {:>22} {:>10} {:>9}  verdict\n", "symbol", "paper", "kind",
                 "computed", "error", "tolerance");
    for (const auto &number : vibro_impact::figures::key_numbers()) {
      const Reference &reference = references.at(number.symbol);
      const double computed = number.compute(), error = std::abs(computed - reference.value);
      const bool pass = error <= number.tolerance;  // false for NaN
      if (!pass) ++failed;
      if (markdown)
        fmt::print("| {} | {} | {} | {:.1e} | {:.0e} | {} |\n", number.meaning, number.printed,
                   shown(number.decimals, computed), error, number.tolerance, reference.kind);
      else
        fmt::print("{:<30} {:<22} {:<11} {:>22} {:>10.1e} {:>9.0e}  {}\n", number.symbol,
                   number.printed, reference.kind, shown(number.decimals, computed), error,
                   number.tolerance, pass ? "pass" : "FAIL");
    }
    if (failed > 0) {
      std::fflush(stdout);
      fmt::print(stderr, "check: {} of the key numbers miss their reference\n", failed);
      return 1;
    }
    return 0;
  } catch (const std::exception &failure) {
    fmt::print(stderr, "check: {}\n", failure.what());
    return 2;
  }
}
