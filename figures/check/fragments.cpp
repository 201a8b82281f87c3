#include "fragments.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <stdexcept>

#include "figures/runs.hpp"
#include "reference/scenes/table1_scenes.hpp"
#include "reference/truth/event_comparison.hpp"
#include "vibro_impact/analysis/analysis.hpp"

namespace vibro_impact::figures {

namespace {

std::vector<std::string> split(const std::string &text, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
  return parts;
}

// A number in a format of {fmt}, or, if that is w, a small count as a word.
std::string formatted(double value, const std::string &format) {
  static const std::vector<std::string> words{"no",   "one",    "two",    "three",   "four",
                                              "five", "six",    "seven",  "eight",   "nine",
                                              "ten",  "eleven", "twelve", "thirteen"};
  if (format != "w") return numbers::formatted(value, format);
  return words.at(static_cast<std::size_t>(value));
}

// --- Tables of the drivers -----------------------------------------------------------------------

std::string path_of(const Sources &sources, const std::string &table) {
  return sources.tables + "/" + table + ".csv";
}

truth::Rows rows_of(const Sources &sources, const std::string &table) {
  return truth::read_rows(path_of(sources, table), 1);
}

double cell(const Sources &sources, const std::string &table, const std::string &begins_with,
            const std::string &column) {
  const truth::Row header = truth::header_of(path_of(sources, table)),
                   first = split(begins_with, ',');
  const auto place = static_cast<std::size_t>(std::ranges::find(header, column) - header.begin());
  for (const truth::Row &row : rows_of(sources, table))
    if (row.size() > std::max(place, first.size()) - 1 &&
        std::equal(first.begin(), first.end(), row.begin(), [](const auto &asked, const auto &is) {
          return asked == is ||
                 (truth::as_number(asked) && truth::as_number(asked) == truth::as_number(is));
        }))
      return std::stod(row.at(place));
  throw std::runtime_error("no such cell");
}

std::string fitting_frequencies(const Sources &sources, const std::string &figure) {
  std::vector<std::string> frequencies;
  for (const truth::Row &row : rows_of(sources, "inferred_frequencies_fits"))
    if (row[0] == figure)
      frequencies.push_back(
          fmt::format(fmt::runtime(row[4] == "1" ? "**{:g}**" : "{:g}"), std::stod(row[1])));
  return fmt::format("{}", fmt::join(frequencies, ", "));
}

// The ranges of frequencies in the rows that begin with a cell; their ends are the last two cells.
std::string ranges_of(const truth::Rows &rows, const std::string &first) {
  std::vector<std::string> ranges;
  for (const truth::Row &row : rows) {
    if (row[0] != first) continue;
    const std::string from = formatted(std::stod(row[row.size() - 2]), ".3f"),
                      to = formatted(std::stod(row.back()), ".3f");
    ranges.push_back(from == to ? from : from + " to " + to);
  }
  return fmt::format("{}", fmt::join(ranges, ", "));
}

std::string table_of_procedures(const Sources &sources) {
  truth::Rows rows{{"procedure", "no complete chatter of mass 1"},
                   {"the paper, as printed", "0.3 to 0.35, 0.37 to 0.4"}};
  const truth::Rows windows = rows_of(sources, "procedures_windows");
  for (const char *procedure :
       {"the exact motion from rest", "period 1 alone", "periods 1 to 2", "frequencies 0.01 apart",
        "cut off: flight < 0.1", "cut off: speed < 0.001", "Eq. 24 as printed"})
    rows.push_back({procedure, ranges_of(windows, procedure)});
  return '\n' + table_of(rows);
}

// --- Computed here -------------------------------------------------------------------------------

// The frequency from which mass 2 hits its stop in Figure 5(b), counted over ten periods after 190
// periods from rest. The settled motion without hits goes on beyond it.
double first_hit_in_figure5b() {
  return bisect(
             [](double omega) {
               Scene scene = with(paper::figure5b(), "omega", omega);
               const double period = Clock(omega).period;
               ImpactVelocityRecorder impacts{2, 190 * period};
               require_complete(simulate(scene, 200 * period, impacts));
               return int{!impacts.velocities.empty()};
             },
             0.2995, 0.2996, 1e-10)
      .above;
}

std::string non_generic_contact() {
  const auto [time, omega] = paper::non_generic_contact;
  const Scene scene = paper::two_masses({1, Side::upper, 5.0}, {2, Side::upper, 10.0}, 0.7, omega);
  return fmt::format("Ω = {:.4f} and s1 = {:.4f}", omega,
                     require_complete(simulate(scene, time)).state.displacement[0]);
}

// --- All fragments -------------------------------------------------------------------------------

// The text of a fragment whose name is one word.
std::string text_named(const std::string &name, const Sources &from) {
  if (name == "verdicts") return count_of_verdicts(from.findings);
  if (name == "results") return count_of_results(from.findings);
  if (name == "speed") return comparison::sentences_of_speed(from.measured);
  if (name == "steppers") return '\n' + table_of(comparison::rows_of_steppers(from.measured));
  if (name == "methods") return '\n' + table_of(comparison::rows_of_methods(from.measured));
  if (name == "procedures") return table_of_procedures(from);
  if (name == "sticking_above") return ranges_of(rows_of(from, "procedures_sticking"), "mass 1");
  if (name == "first_hit") return formatted(first_hit_in_figure5b(), ".8f");
  if (name == "non_generic") return non_generic_contact();
  if (name == "grazing_speed") return formatted(truth::grazing_speed, "g");
  const Finding &finding = number_of(from.findings, name);
  return finding.number.formatted(finding.computed);
}

// The words of a class, with the name of a file in tests.
std::string class_of_claim(std::string words, const std::string &test) {
  std::ranges::replace(words, '_', ' ');
  numbers::word_in("claim", words, numbers::verdict_words);
  for (const auto &folder : std::filesystem::directory_iterator(SOURCE_DIR "/tests"))
    if (std::filesystem::exists(folder.path() / (test + ".cpp")))
      return fmt::format("{} (`{}`)", words, test);
  throw std::runtime_error("no such test");
}

// How many key numbers are of one of some classes, or begin with one of some prefixes.
double count_of(const Findings &findings, const std::string &asked) {
  const std::vector<std::string> words = split(asked, '+');
  return static_cast<double>(std::ranges::count_if(findings, [&](const Finding &finding) {
    return finding.number.of_the_paper() && std::ranges::any_of(words, [&](const auto &word) {
             return finding.number.id.starts_with(word) || name(finding.verdict()) == word;
           });
  }));
}

}  // namespace

std::string text_of(const std::string &fragment, const Sources &sources) {
  const std::vector<std::string> parts = split(fragment, ':');
  const std::string &kind = parts.at(0);
  if (parts.size() == 1) return text_named(kind, sources);
  if (kind == "class") return name(number_of(sources.findings, parts[1]).verdict());
  if (kind == "fits") return fitting_frequencies(sources, parts[1]);
  if (kind == "claim") return class_of_claim(parts[1], parts.at(2));
  if (kind == "count") return formatted(count_of(sources.findings, parts[1]), parts.at(2));
  if (parts.size() == 2) return formatted(number_of(sources.findings, kind).computed, parts[1]);
  return formatted(cell(sources, kind, parts[1], parts[2]), parts.at(3));
}

}  // namespace vibro_impact::figures
