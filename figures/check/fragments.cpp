#include "fragments.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>
#include <map>
#include <sstream>
#include <stdexcept>

#include "figures/runs.hpp"
#include "reference/scenes/table1_scenes.hpp"
#include "reference/truth/event_comparison.hpp"
#include "reference/truth/extreme_cases.hpp"
#include "vibro_impact/analysis/analysis.hpp"

namespace vibro_impact::figures {

using numbers::Verdict;

const std::vector<Claim> &claims() {
  static const std::vector<Claim> all{
      {"model", Verdict::agrees, "random_scenes_test"},
      {"restitution", Verdict::agrees, "corrections_test"},
      {"misprints", Verdict::agrees_otherwise, "corrections_test"},
      {"complete_chatter", Verdict::agrees, "reference_test"},
      {"non_generic_contact", Verdict::agrees, "corrections_test"},
      {"end_of_sticking", Verdict::agrees, "corrections_test"},
      {"border_orbits", Verdict::agrees, "sticking_changes_test"},
      {"restricted_motion", Verdict::agrees_otherwise, "corrections_test"},
      {"exit_boundary_of_mass_1", Verdict::agrees, "corrections_test"},
      {"grazing_sliding", Verdict::cannot_be_judged, "corrections_test"},
      {"table_1", Verdict::agrees, "event_pairs_test"}};
  return all;
}

namespace {

std::vector<std::string> split(const std::string &text, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
  return parts;
}

// A number in a format.
std::string formatted(double value, const std::string &format) {
  constexpr const char *words[] = {"no",  "one",   "two",   "three", "four", "five",
                                   "six", "seven", "eight", "nine",  "ten"};
  if (format == "w") return value <= 10.0 ? words[std::lround(value)] : fmt::format("{}", value);
  return numbers::formatted(value, format);
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

const std::map<std::string, std::function<std::string(const Sources &)>> texts{
    {"verdicts", [](const Sources &from) { return count_of_verdicts(from.findings); }},
    {"results", [](const Sources &from) { return count_of_results(from.findings); }},
    {"key_table",
     [](const Sources &from) {
       return '\n' +
              table_of_few(from.findings, {"multi_sliding_mass_1", "border_mass_1_2",
                                           "border_mass_1_3", "figure3_sticks_of_mass_1_at_0_65",
                                           "figure5a_impacts_while_stuck", "figure5b_dual_sticks"});
     }},
    {"speed", [](const Sources &from) { return comparison::sentences_of_speed(from.measured); }},
    {"steppers",
     [](const Sources &from) {
       return '\n' + table_of(comparison::rows_of_steppers(from.measured));
     }},
    {"methods",
     [](const Sources &from) {
       return '\n' + table_of(comparison::rows_of_methods(from.measured));
     }},
    {"procedures", table_of_procedures},
    {"sticking_above",
     [](const Sources &from) { return ranges_of(rows_of(from, "procedures_sticking"), "mass 1"); }},
    {"first_hit", [](const Sources &) { return formatted(first_hit_in_figure5b(), ".8f"); }},
    {"non_generic", [](const Sources &) { return non_generic_contact(); }},
    {"grazing_speed", [](const Sources &) { return formatted(truth::grazing_speed, "g"); }},
    {"touches", [](const Sources &) {
       return formatted(static_cast<double>(std::ranges::count(
                            truth::extreme_cases(), truth::Truth::grazing, &truth::Case::truth)),
                        "w");
     }}};

// How many key numbers are of a class, or begin with a prefix.
double count_of(const Findings &findings, const std::string &what) {
  return static_cast<double>(std::ranges::count_if(findings, [&](const Finding &finding) {
    return finding.number.of_the_paper() &&
           (finding.number.id.starts_with(what) || name(finding.verdict()) == what);
  }));
}

}  // namespace

std::string text_of(const std::string &fragment, const Sources &sources) {
  const std::vector<std::string> parts = split(fragment, ':');
  const std::string &kind = parts.at(0);
  if (parts.size() == 1) {
    const auto text = texts.find(kind);
    if (text != texts.end()) return text->second(sources);
    const Finding &finding = number_of(sources.findings, kind);
    return finding.number.formatted(finding.computed);
  }
  if (kind == "class") return name(number_of(sources.findings, parts[1]).verdict());
  if (kind == "fits") return fitting_frequencies(sources, parts[1]);
  if (kind == "claim") {
    for (const Claim &claim : claims())
      if (claim.name == parts[1]) return fmt::format("{} (`{}`)", name(claim.verdict), claim.test);
    throw std::runtime_error("no such claim");
  }
  if (kind == "count") return formatted(count_of(sources.findings, parts[1]), parts.at(2));
  if (parts.size() == 2) return formatted(number_of(sources.findings, kind).computed, parts[1]);
  return formatted(cell(sources, kind, parts[1], parts[2]), parts.at(3));
}

}  // namespace vibro_impact::figures
