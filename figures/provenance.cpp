// Where the figures come from: a manifest beside them, SHA256SUMS, which `sha256sum -c` reads
// (version, commit, compiler, libraries, processor, and the sum of every table and picture); and a
// comparison with the run stored in the repository: byte for byte where the platform is the same,
// else number by number.
#include <fmt/chrono.h>

#include <boost/version.hpp>
#include <ctime>
#include <sstream>

#include "driver.hpp"
#include "stored_tables.hpp"

namespace {

using namespace vibro_impact;
using namespace vibro_impact::figures;
using std::filesystem::path;

// The commit, with "+" when files differ from it; that of the archive where there is no repository.
std::string manifest_of(const path &folder) {
  const std::string commit = first_line_of(
      "git -C '" SOURCE_DIR
      "' describe --always --abbrev=40 --exclude '*' --dirty=+ || grep -v '^\\$' '" SOURCE_DIR
      "/.commit'");
  return fmt::format(
      "# platform: {}\n# software: vibro-impact {}\n# commit: {}\n# written: {:%FT%TZ}\n"
      "# with: Boost {}, fmt {}, {}, {}\n{}",
      platform(), VIBRO_IMPACT_VERSION, commit, fmt::gmtime(std::time(nullptr)), BOOST_LIB_VERSION,
      FMT_VERSION, first_line_of("gnuplot --version"), first_line_of("uname -sr"),
      output_of(
          fmt::format("cd '{}' && sha256sum $(ls | grep -E '[.](csv|png)$')", folder.string())));
}

void save(const path &file, const std::string &text) {
  Table table("");
  table.text = text;
  write(table, file.string());
}

path extract_of(const path &stored, const std::string &table) {
  return stored / path(table).replace_extension(".extract");
}

// The manifest, and an extract of every table that can be compared.
void store(const path &folder, const path &stored) {
  const Rules rules = read_rules(stored / "rules.csv");
  for (const auto &entry : std::filesystem::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (name.ends_with(".csv") && rule_for(rules, name).tolerance)
      save(extract_of(stored, name), extract(entry, rule_for(rules, name).until));
  }
  save(stored / "SHA256SUMS", manifest_of(folder));
}

// Prints a line per table that is not the same, and a summary. True when none differs by more than
// its rule allows, nor is missing (of those whose names begin with one of `drivers`).
bool compare(const path &folder, const path &stored, const std::vector<std::string> &drivers) {
  const Rules rules = read_rules(stored / "rules.csv");
  int same = 0, near = 0, not_compared = 0, beyond = 0;
  std::istringstream checked(
      output_of(fmt::format("cd '{}' && sha256sum -c '{}' 2>/dev/null", folder.string(),
                            (stored / "SHA256SUMS").string())));
  for (std::string line; std::getline(checked, line);) {  // name: OK
    const std::string name = line.substr(0, line.find(": "));
    if (!name.ends_with(".csv") || std::none_of(drivers.begin(), drivers.end(),
                                                [&](const auto &d) { return name.starts_with(d); }))
      continue;
    const Rule &rule = rule_for(rules, name);
    std::string why;
    if (line.ends_with(": OK")) {
      ++same;
    } else if (!std::filesystem::exists(folder / name)) {
      why = "is missing";
    } else if (!rule.tolerance) {
      ++not_compared;
    } else {
      why =
          difference(extract(folder / name, rule.until), extract_of(stored, name), *rule.tolerance);
      if (why.empty()) fmt::print("{}: the same within {:.0e}\n", name, *rule.tolerance);
      near += why.empty() ? 1 : 0;
    }
    if (!why.empty()) fmt::print("{}: {}\n", name, why);
    beyond += why.empty() ? 0 : 1;
  }
  fmt::print(
      "{} tables the same byte for byte, {} within their tolerance, {} not to be compared, {} "
      "beyond or missing\n",
      same, near, not_compared, beyond);
  const std::string there = first_line_of(
      fmt::format("sed -n 's/^# platform: //p' '{}'", (stored / "SHA256SUMS").string()));
  if (there != platform())
    fmt::print("stored on {}\nthis is   {}\n", there, platform());
  else if (near > 0)
    fmt::print("the platform is the same: these tables should be, too\n");
  return beyond == 0 && same + near > 0 && (near == 0 || there != platform());
}

}  // namespace

int main(int argc, char **argv) {
  std::string output = "build/figures", stored = SOURCE_DIR "/figures/stored", drivers;
  bool keep = false;
  return command(
      argc, argv, "The manifest of the figures, and a comparison with the stored run",
      {{"--output", "Folder of the tables and pictures", &output},
       {"--stored", "Folder of the stored run", &stored},
       {"--drivers", "Only tables whose names begin with one of these (a,b,...)", &drivers},
       {"--store", "Store this run instead of comparing with it", &keep}},
      [&] {
        save(path(output) / "SHA256SUMS", manifest_of(output));
        if (!keep) return compare(output, stored, cells_of(drivers)) ? 0 : 1;
        store(output, stored);
        return 0;
      });
}
