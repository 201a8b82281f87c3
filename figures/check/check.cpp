// `make check`: compares every key number with its reference and with what the paper says of it,
// and every result of other authors with what the library computes. The last line says whether all
// of them passed. The fragments of the documents are compared, too, or written (--write).
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "documents.hpp"
#include "figures/driver.hpp"
#include "fragments.hpp"

namespace {

using namespace vibro_impact;
using namespace vibro_impact::figures;

constexpr const char *explanation =
    "agrees: within half a unit of the last printed digit, between the two ticks where an axis "
    "ends, or true as stated\n"
    "close: to two decimals a value that the paper reads off Figure 3\n"
    "inferred: the paper's text lacks a parameter of the figure\n"
    "error: of the computed number against its reference; above the allowed error it fails\n";

constexpr const char *documents[] = {"README.md", "figures/README.md",
                                     "figures/error_vs_runtime/README.md",
                                     "figures/stability/README.md", "reference/README.md"};

std::string content_of(const std::string &path) {
  std::ostringstream text;
  text << truth::opened(path).rdbuf();
  return text.str();
}

// Compares the documents in a folder, after it has written them if `write` says so. Returns their
// faults.
std::vector<std::string> faults_of_documents(const std::string &folder, bool write,
                                             const Sources &sources) {
  const TextOf text = [&](const std::string &fragment) { return text_of(fragment, sources); };
  std::vector<std::string> faults;
  for (const std::string name : documents) {
    const std::string path = folder + "/" + name;
    Document document = renewed(name, content_of(path), text);
    if (write) {
      std::ofstream(path) << document.text;
      document = renewed(name, document.text, text);
    }
    faults.insert(faults.end(), document.faults.begin(), document.faults.end());
  }
  return faults;
}

// Prints the last lines. Returns the exit status, which is 1 if anything missed.
int conclude(const Findings &findings, const std::vector<std::string> &faults) {
  std::vector<std::string> missed;
  for (const Finding &finding : findings)
    if (!finding.pass())
      missed.push_back(finding.failure.empty() ? finding.number.id : finding.failure);
  for (const std::string &fault : faults) fmt::print("\n{}", fault);
  const std::string counts = count_of_verdicts(findings) + "; " + count_of_results(findings);
  if (missed.empty() && faults.empty()) {
    fmt::print("\nall passed. {}\n", counts);
    return 0;
  }
  fmt::print("\nFAILED: {}\nmissed: {}\nfaults of documents: {}\n", counts, fmt::join(missed, ", "),
             faults.size());
  return 1;
}

}  // namespace

int main(int argc, char **argv) {
  std::string reference, tables, compared, written;
  const auto given_or = [](const std::string &given, const char *folder_of_project) {
    return given.empty() ? std::string(folder_of_project) : given;
  };
  return command(
      argc, argv, "Computes every key number and every published result and compares them",
      {{"--reference", "Folder of the tables of references, if not that of the project",
        &reference},
       {"--tables", "Folder of the tables that the drivers have written, if not build/figures",
        &tables},
       {"--documents", "Folder whose documents are compared, if not the project", &compared},
       {"--write", "Folder of the project, whose documents are written instead", &written}},
      [&] {
        const Sources sources{
            findings(given_or(reference, REFERENCE_DIR)),
            comparison::read_measured(SOURCE_DIR "/figures/error_vs_runtime/measured.csv"),
            given_or(tables, TABLES_DIR)};
        fmt::print("{}{}", explanation, tables_of(sources.findings));
        const bool write = !written.empty();
        const std::string folder = write ? written : given_or(compared, SOURCE_DIR);
        return conclude(sources.findings, faults_of_documents(folder, write, sources));
      });
}
