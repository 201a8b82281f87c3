// Where the figures come from: a manifest beside them (version, commit, compiler, libraries,
// processor, parameters, SHA-256 of every table and picture), and a comparison with the run stored
// in the repository: byte for byte where the platform is the same, else number by number.
#include <ctime>

#include "driver.hpp"
#include "platform.hpp"
#include "stored_tables.hpp"
#include "table_reader.hpp"
#include "vibro_impact/analysis/parameter.hpp"

namespace {

using namespace vibro_impact;
using namespace vibro_impact::figures;
using std::filesystem::path;

constexpr std::size_t rows_kept = 41;  // of a table, in the repository

// Text in JSON.
std::string json(const std::string &text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result + '"';
}

template <class Pairs>
std::string object(const Pairs &pairs, const std::string &indent) {
  std::vector<std::string> lines;
  for (const auto &[name, value] : pairs)
    lines.push_back(fmt::format("{}  {}: {}", indent, json(name), value));
  return fmt::format("{{\n{}\n{}}}", fmt::join(lines, ",\n"), indent);
}

// The commit, with "+" when files differ from it; that of the archive where there is no repository;
// none where the files are a copy without either.
std::string commit() {
  const std::string git = "git -C '" SOURCE_DIR "' ";
  const std::string head = first_line_of(git + "rev-parse HEAD");
  if (!head.empty())
    return head + (first_line_of(git + "status --porcelain -uno").empty() ? "" : "+");
  const std::string archived = first_line_of("cat '" SOURCE_DIR "/.commit'");
  return archived.starts_with('$') ? "" : archived;
}

std::string parameters_of(const Scene &scene) {
  std::vector<std::pair<std::string, std::string>> values;
  const auto add = [&](const Parameter &parameter) {
    values.emplace_back(name(parameter), fmt::format("{}", get(scene, parameter)));
  };
  add({Parameter::Kind::omega});
  add({Parameter::Kind::beta});
  add({Parameter::Kind::restitution});
  for (int i = 1; i <= scene.masses(); ++i)
    for (const auto kind :
         {Parameter::Kind::mass, Parameter::Kind::stiffness, Parameter::Kind::amplitude})
      add({kind, i});
  for (std::size_t k = 0; k < scene.stops.size(); ++k) {
    const Stop &stop = scene.stops[k];
    values.emplace_back(fmt::format("stop{}", k + 1),
                        json(fmt::format("{}:{}:{}", stop.mass, name(stop.side), stop.position)));
  }
  return object(values, "    ");
}

std::string manifest(const Sums &sums) {
  std::vector<std::pair<std::string, std::string>> with, scenes, files;
  for (const auto &[name, value] : made_with()) with.emplace_back(name, json(value));
  for (const auto &[name, scene, until] : paper::named_scenes())
    scenes.emplace_back(name, parameters_of(scene));
  for (const auto &[name, sum] : sums.of) files.emplace_back(name, json(sum));
  const std::time_t now = std::time(nullptr);
  char date[32] = {};
  std::strftime(date, sizeof date, "%Y-%m-%dT%H:%M:%SZ", std::gmtime(&now));
  return object(
             std::vector<std::pair<std::string, std::string>>{
                 {"software", json("vibro-impact " VIBRO_IMPACT_VERSION)},
                 {"commit", json(commit())},
                 {"written", json(date)},
                 {"made with", object(with, "  ")},
                 {"scenes", object(scenes, "  ")},
                 {"SHA-256", object(files, "  ")}},
             "") +
         "\n";
}

void save(const path &file, const std::string &text) {
  Table table("");
  table.text = text;
  write(table, file.string());
}

bool is_table(const std::string &name) {
  return path(name).extension() == ".csv";
}

// Keeps the sums and an extract of every table that can be compared.
void store(const path &folder, const path &stored, const Sums &sums) {
  const Rules rules = read_rules(stored / "rules.csv");
  for (const auto &[name, sum] : sums.of) {
    const Rule &rule = rule_for(rules, name);
    if (is_table(name) && rule.compared)
      save(stored / (path(name).stem().string() + ".extract"),
           text_of(extract(folder / name, rows_kept, rule.until)));
  }
  save(stored / "SHA256SUMS", text_of(sums));
  fmt::print("stored: {} sums, {}\n", sums.of.size(), sums.platform);
}

// Prints a line per table that is not the same, and a summary. True when none differs by more than
// its rule allows, nor is missing (of those whose names begin with one of `drivers`).
bool compare(const path &folder, const path &stored, const Sums &sums,
             const std::vector<std::string> &drivers) {
  const Rules rules = read_rules(stored / "rules.csv");
  const Sums before = read_sums(stored / "SHA256SUMS");
  int same = 0, near = 0, timings = 0, beyond = 0;
  const auto wanted = [&](const std::string &name) {
    return std::any_of(drivers.begin(), drivers.end(),
                       [&](const std::string &driver) { return name.starts_with(driver); });
  };
  for (const auto &[name, sum] : before.of) {
    if (!is_table(name) || !wanted(name)) continue;
    const auto fresh = sums.of.find(name);
    const Rule &rule = rule_for(rules, name);
    if (fresh == sums.of.end()) {
      fmt::print("{}: missing\n", name);
      ++beyond;
    } else if (fresh->second == sum) {
      ++same;
    } else if (!rule.compared) {
      ++timings;
    } else {
      const Difference found =
          difference(extract(folder / name, rows_kept, rule.until),
                     read_extract(stored / (path(name).stem().string() + ".extract")));
      const bool within = found.reason.empty() && found.largest <= rule.tolerance;
      fmt::print("{}: {}{}\n", name,
                 found.reason.empty()
                     ? fmt::format("differs by {:.1e} ({}), allowed {:.0e}", found.largest,
                                   found.where.empty() ? "in rows not stored" : found.where,
                                   rule.tolerance)
                     : found.reason,
                 within ? "" : " <-- beyond");
      ++(within ? near : beyond);
    }
  }
  fmt::print(
      "{} tables the same byte for byte, {} within their tolerance, {} not to be "
      "compared, {} beyond or missing\n",
      same, near, timings, beyond);
  if (sums.platform != before.platform)
    fmt::print("stored on {}\nthis is   {}\n", before.platform, sums.platform);
  else if (near > 0)
    fmt::print("the platform is the same: these tables should be, too\n");
  return beyond == 0 && (near == 0 || sums.platform != before.platform);
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
        const Sums sums = sums_of(output, platform());
        save(path(output) / "manifest.json", manifest(sums));
        if (keep) {
          store(output, stored, sums);
          return 0;
        }
        return compare(output, stored, sums, cells_of(drivers)) ? 0 : 1;
      });
}
