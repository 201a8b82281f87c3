// `make check`: compares every key number with its reference and with what the paper says of it,
// and every result of other authors with what the library computes. The last line says whether all
// of them passed. The computed parts of the documents are compared (--documents) or written
// (--write).
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "documents.hpp"
#include "figures/driver.hpp"

namespace {

using namespace vibro_impact;
using namespace vibro_impact::figures;

constexpr const char *explanation =
    "agrees: within half a unit of the last printed digit, between the two ticks where an axis "
    "ends, or true as stated\n"
    "close: to two decimals a value that the paper reads off Figure 3\n"
    "depends on an inferred value: the paper's text lacks a parameter of the figure\n"
    "error: of the computed number against its reference; above the allowed error it fails\n";

constexpr const char *explanation_of_published =
    "id: the row of reference/tables/checked_numbers.csv, which has the parameters\n"
    "source: reference/README.md\n"
    "limited by: what keeps the two apart, our computation, theirs, or both\n";

// A document with computed parts: what it must have, and whether its numbers are key numbers only.
struct Document {
  std::string name;
  std::vector<std::string> required;
  bool only_key_numbers;
};

const Document documents[] = {{"README.md", {"few", "counts", "speed"}, true},
                              {"figures/README.md", {"counts", "class"}, true},
                              {"figures/error_vs_runtime/README.md", {"methods"}, false},
                              {"reference/README.md", {"published"}, false}};

std::string content_of(const std::string &path) {
  std::ostringstream text;
  text << truth::opened(path).rdbuf();
  return text.str();
}

// Adds what is wrong with a document: a missing part, its first line that must be another one, and
// numbers that are no key numbers.
void add_faults(const Results &results, const std::string &folder, const Document &document,
                std::vector<std::string> &faults) {
  const std::string text = content_of(folder + "/" + document.name);
  for (const std::string &part : document.required)
    if (text.find("<!--check " + part) == std::string::npos)
      faults.push_back(fmt::format("{}: has no <!--check {}", document.name, part));
  std::istringstream found(text), expected(with_computed_parts(results, text));
  std::string line, right;
  for (int number = 1; std::getline(expected, right); ++number) {
    if (std::getline(found, line) && line == right) continue;
    faults.push_back(fmt::format("{}:{}: must be: {}", document.name, number, right));
    break;
  }
  if (!document.only_key_numbers) return;
  for (const std::string &word : unknown_numbers(results, text))
    faults.push_back(fmt::format("{}: {} is no key number rounded", document.name, word));
}

void write_documents(const Results &results, const std::string &folder) {
  for (const Document &document : documents) {
    const std::string path = folder + "/" + document.name;
    const std::string text = with_computed_parts(results, content_of(path));
    std::ofstream file(path);
    file << text;
    file.close();
    if (!file) throw std::runtime_error(path + ": cannot be written");
  }
}

// Prints the last lines. Returns the exit status, which is 1 if anything missed.
int conclude(const Results &results, const std::vector<std::string> &faults) {
  std::vector<std::string> missed;
  for (const Finding &finding : results.findings)
    if (!finding.pass()) missed.push_back(finding.number.id);
  for (const std::string &fault : faults) fmt::print("\n{}", fault);
  const std::string counts =
      count_of_verdicts(results.findings) + "; " + count_of_results(results.findings);
  if (missed.empty() && faults.empty()) {
    fmt::print("\nall passed: {}\n", counts);
    return 0;
  }
  fmt::print("\nFAILED: of {}; missed: {}; faults of documents: {}\n", counts,
             fmt::join(missed, ", "), faults.size());
  return 1;
}

}  // namespace

int main(int argc, char **argv) {
  std::string reference, compared, written;
  const std::string measured = SOURCE_DIR "/figures/error_vs_runtime/measured.csv";
  return command(argc, argv,
                 "Computes every key number and every published result and compares them",
                 {{"--reference", "Folder of the tables of references, if not that of the project",
                   &reference},
                  {"--documents", "Folder of the project, whose documents are compared", &compared},
                  {"--write", "Folder of the project, whose documents are written", &written}},
                 [&] {
                   if (reference.empty()) reference = REFERENCE_DIR;
                   const Results results{findings(reference), comparison::read_measured(measured)};
                   fmt::print("{}{}\n**Published by others**\n\n{}\n{}", explanation,
                              tables_by_verdict(results.findings), explanation_of_published,
                              table_of_results(results.findings));
                   if (!written.empty()) write_documents(results, written);
                   std::vector<std::string> faults;
                   for (const Document &document : documents)
                     if (!compared.empty()) add_faults(results, compared, document, faults);
                   return conclude(results, faults);
                 });
}
