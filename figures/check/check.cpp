// `make check`: compares every key number with its reference and with what the paper says of it,
// and every result of other authors with what the library computes. The fragments of the documents
// are compared, too, or written (--write), and the numbers beside them with the list of quotations.
// The last line says whether all of them passed.
#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "figures/driver.hpp"
#include "fragments.hpp"
#include "quotations.hpp"

namespace {

using namespace vibro_impact::figures;

constexpr const char *documents[] = {"README.md", "figures/README.md",
                                     "figures/error_vs_runtime/README.md",
                                     "figures/stability/README.md", "reference/README.md"};

}  // namespace

int main(int argc, char **argv) {
  std::string reference, written;  // empty for those of the project
  return run_program(
      argc, argv, "Computes every key number and every published result and compares them",
      {{"--reference", "Folder of the tables of references, if not the project's", &reference},
       {"--write", "Folder of the project, whose documents are written first", &written}},
      [&] {
        if (!std::filesystem::exists(TABLES_DIR "/figure4a.csv"))
          throw std::runtime_error(TABLES_DIR
                                   ": the tables of the figures are missing; `make check` computes "
                                   "them");
        const std::string measured = SOURCE_DIR "/figures/error_vs_runtime/measured.csv";
        const std::string folder = reference.empty() ? REFERENCE_DIR : reference;
        const Findings computed = findings(folder);
        const Sources sources{computed, claims(REFERENCE_DIR, computed),
                              vibro_impact::comparison::read_measured(measured), TABLES_DIR};
        fmt::print("{}", table_of(sources.findings));
        bool passed = true;
        const auto fail = [&](const std::string &reason) {
          fmt::print("\nmissed: {}", reason);
          passed = false;
        };
        for (const Finding &finding : sources.findings)
          if (!finding.pass()) fail(finding.failure.empty() ? finding.number.id : finding.failure);
        for (const std::string name : documents) {
          const std::string path = (written.empty() ? SOURCE_DIR : written) + "/" + name;
          std::ifstream file = vibro_impact::truth::opened(path);
          Document document = renewed(name, {std::istreambuf_iterator<char>(file), {}}, sources);
          if (!written.empty()) {
            std::ofstream(path) << document.text;
            document = renewed(name, document.text, sources);
          }
          for (const std::string &fault : document.faults) fail(fault);
          if (name != "README.md" && name != "figures/README.md") continue;
          const auto quotations = quotations_of(REFERENCE_DIR, name);
          for (const std::string &fault : numbers_without_origin(name, document.text, quotations))
            fail(fault);
        }
        fmt::print("\n{}: {} numbers, and those of the documents\n",
                   passed ? "all passed" : "FAILED", sources.findings.size());
        return passed ? 0 : 1;
      });
}
