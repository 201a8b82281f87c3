// `make check`: compares every key number with its reference and with what the paper says of it,
// and every result of other authors with what the library computes. The last line says whether all
// of them passed. The fragments of the documents are compared, too, or written (--write).
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <fstream>
#include <iterator>

#include "documents.hpp"
#include "figures/driver.hpp"
#include "fragments.hpp"

namespace {

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

// The faults of a document. They are mended in the file if `write` says so.
std::vector<std::string> faults_of(const std::string &path, bool write, const TextOf &text_of) {
  std::ifstream file = vibro_impact::truth::opened(path);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  const Document document = renewed(path, text, text_of);
  if (!write) return document.faults;
  std::ofstream(path) << document.text;
  return renewed(path, document.text, text_of).faults;
}

}  // namespace

int main(int argc, char **argv) {
  std::string reference, compared, written;  // empty for those of the project
  return command(
      argc, argv, "Computes every key number and every published result and compares them",
      {{"--reference", "Folder of the tables of references, if not the project's", &reference},
       {"--documents", "Folder whose documents are compared, if not the project", &compared},
       {"--write", "Folder whose documents are written instead", &written}},
      [&] {
        const std::string measured = SOURCE_DIR "/figures/error_vs_runtime/measured.csv";
        const Sources sources{findings(reference.empty() ? REFERENCE_DIR : reference),
                              vibro_impact::comparison::read_measured(measured), TABLES_DIR};
        fmt::print("{}{}", explanation, tables_of(sources.findings));
        bool passed = true;
        const auto fail = [&](const std::string &reason) {
          fmt::print("\nmissed: {}", reason);
          passed = false;
        };
        for (const Finding &finding : sources.findings)
          if (!finding.pass()) fail(finding.failure.empty() ? finding.number.id : finding.failure);
        if (compared.empty()) compared = SOURCE_DIR;
        const std::string folder = written.empty() ? compared : written;
        for (const std::string document : documents)
          for (const std::string &fault :
               faults_of(folder + "/" + document, !written.empty(),
                         [&](const std::string &name) { return text_of(name, sources); }))
            fail(fault);
        fmt::print("\n{} {}; {}\n",
                   passed ? "all passed." : "FAILED:", count_of_verdicts(sources.findings),
                   count_of_results(sources.findings));
        return passed ? 0 : 1;
      });
}
