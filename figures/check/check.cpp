// `make check`: compares every key number with its reference and with what the paper says of it,
// and every result of other authors with what the library computes. The last line says whether all
// of them passed. With --documents, what the documents quote is compared, too.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <sstream>
#include <string>
#include <vector>

#include "documents.hpp"
#include "figures/driver.hpp"
#include "figures/error_vs_runtime/measured.hpp"

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

// The documents that quote these findings, and the table of error against run time.
std::vector<Document> documents_on(const Findings &findings,
                                   const std::vector<comparison::Measured> &measured) {
  return {
      {"README.md",
       {count_of_verdicts(findings),
        table_of_few(findings, {"multi_sliding_mass_1", "border_mass_1_2", "border_mass_1_3",
                                "figure3_sticks_of_mass_1_at_0_65", "figure5a_impacts_while_stuck",
                                "figure5b_dual_sticks"}),
        comparison::sentences_of_speed(measured), table_of(comparison::rows_of_steppers(measured))},
       true},
      {"figures/README.md", {}, true},
      {"figures/error_vs_runtime/README.md",
       {table_of(comparison::rows_of_methods(measured))},
       false},
      {"reference/README.md", {count_of_results(findings)}, false}};
}

std::string content_of(const std::string &path) {
  std::ostringstream text;
  text << truth::opened(path).rdbuf();
  return text.str();
}

// Prints the last lines. Returns the exit status, which is 1 if anything missed.
int conclude(const Findings &findings, const std::vector<std::string> &faults) {
  std::vector<std::string> missed;
  for (const Finding &finding : findings)
    if (!finding.pass()) missed.push_back(finding.number.id);
  for (const std::string &fault : faults) fmt::print("\n{}", fault);
  const std::string counts = count_of_verdicts(findings) + "; " + count_of_results(findings);
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
  std::string reference, documents;
  const std::string measured = SOURCE_DIR "/figures/error_vs_runtime/measured.csv";
  return command(
      argc, argv, "Computes every key number and every published result and compares them",
      {{"--reference", "Folder of the tables of references, if not that of the project",
        &reference},
       {"--documents", "Folder of the project, whose documents are compared", &documents}},
      [&] {
        const Findings found = findings(reference.empty() ? REFERENCE_DIR : reference);
        fmt::print("{}{}\n**Published by others**\n\n{}\n{}", explanation, tables_by_verdict(found),
                   explanation_of_published, table_of_results(found));
        std::vector<std::string> faults;
        if (!documents.empty())
          for (const Document &document : documents_on(found, comparison::read_measured(measured)))
            for (const std::string &fault :
                 faults_of(found, document, content_of(documents + "/" + document.name)))
              faults.push_back(fault);
        return conclude(found, faults);
      });
}
