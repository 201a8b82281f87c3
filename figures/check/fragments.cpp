#include "fragments.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <regex>
#include <sstream>
#include <stdexcept>

#include "reference/truth/event_comparison.hpp"

namespace vibro_impact::figures {

namespace {

std::vector<std::string> split(const std::string &text, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
  return parts;
}

// --- Tables of the drivers -----------------------------------------------------------------------

std::string path_of(const Sources &sources, const std::string &table) {
  return sources.tables + "/" + table + ".csv";
}

double cell(const std::string &path, const std::string &begins_with, const std::string &column) {
  const truth::Row header = truth::header_of(path), first = split(begins_with, ',');
  const auto place = static_cast<std::size_t>(std::ranges::find(header, column) - header.begin());
  const auto same = [](const std::string &asked, const std::string &is) {
    return truth::as_number(is) == std::stod(asked);
  };
  for (const truth::Row &row : truth::read_rows(path, header.size()))
    if (std::mismatch(first.begin(), first.end(), row.begin(), row.end(), same).first ==
        first.end())
      return std::stod(row.at(place));
  throw std::runtime_error("no such cell");
}

std::string fitting_frequencies(const Sources &sources, const std::string &figure) {
  std::vector<std::string> frequencies;
  for (const truth::Row &row : truth::read_rows(path_of(sources, "inferred_frequencies_fits"), 5))
    if (row[0] == figure)
      frequencies.push_back(
          fmt::format(fmt::runtime(row[4] == "1" ? "**{:g}**" : "{:g}"), std::stod(row[1])));
  return fmt::format("{}", fmt::join(frequencies, ", "));
}

// The ranges of frequencies in the rows that begin with a cell; their ends are the last two cells.
std::string ranges_of(const std::string &path, const std::string &first) {
  std::vector<std::string> ranges;
  for (const truth::Row &row : truth::read_rows(path, 3)) {
    if (row[0] != first) continue;
    const std::string from = numbers::formatted(std::stod(row[row.size() - 2]), ".3f"),
                      to = numbers::formatted(std::stod(row.back()), ".3f");
    ranges.push_back(from == to ? from : from + " to " + to);
  }
  return fmt::format("{}", fmt::join(ranges, ", "));
}

std::string table_of_procedures(const Sources &sources) {
  truth::Rows rows{{"procedure", "no complete chatter of mass 1"},
                   {"the paper, as printed", "0.3 to 0.35, 0.37 to 0.4"}};
  for (const char *procedure :
       {"the exact motion from rest", "period 1 alone", "periods 1 to 2", "frequencies 0.01 apart",
        "cut off: flight < 0.1", "cut off: speed < 0.001", "Eq. 24 as printed"})
    rows.push_back({procedure, ranges_of(path_of(sources, "procedures_windows"), procedure)});
  return '\n' + table_of(rows);
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
  if (name == "sticking_above") return ranges_of(path_of(from, "procedures_sticking"), "mass 1");
  if (name == "grazing_speed") return numbers::formatted(truth::grazing_speed, "g");
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
auto count_of(const Findings &findings, const std::string &asked) {
  const std::vector<std::string> words = split(asked, '+');
  return std::ranges::count_if(findings, [&](const Finding &finding) {
    return finding.number.of_the_paper() && std::ranges::any_of(words, [&](const auto &word) {
             return finding.number.id.starts_with(word) || name(finding.verdict()) == word;
           });
  });
}

// --- Documents -----------------------------------------------------------------------------------

// The text with one blank for every sequence of blanks and line breaks.
std::string on_one_line(const std::string &text) {
  static const std::regex space(R"(\s+)");
  return std::regex_replace(text, space, " ");
}

// Whether nothing but a bullet stands before this place in its line.
bool begins_a_line(const std::string &text, std::size_t place) {
  const auto last = text.find_last_not_of(" -", place - 1);
  return place == 0 || last == std::string::npos || text[last] == '\n';
}

}  // namespace

std::string text_of(const std::string &fragment, const Sources &sources) {
  const std::vector<std::string> parts = split(fragment, ':');
  const std::string &kind = parts.at(0);
  if (parts.size() == 1) return text_named(kind, sources);
  if (kind == "class") return name(number_of(sources.findings, parts[1]).verdict());
  if (kind == "fits") return fitting_frequencies(sources, parts[1]);
  if (kind == "claim") return class_of_claim(parts[1], parts.at(2));
  if (kind == "count") return fmt::format("{}", count_of(sources.findings, parts[1]));
  const double number = parts.size() == 2 ? number_of(sources.findings, kind).computed
                                          : cell(path_of(sources, kind), parts[1], parts[2]);
  return numbers::formatted(number, parts.back());
}

Document renewed(const std::string &name, const std::string &text, const Sources &sources) {
  const std::string opening = "<!--=", opened = "-->", closing = "<!--/-->";
  Document document;
  std::size_t done = 0;
  for (auto begin = text.find(opening); begin != std::string::npos;
       begin = text.find(opening, done)) {
    const auto named = begin + opening.size(), from = text.find(opened, named) + opened.size(),
               to = text.find(closing, from);
    const std::string fragment = text.substr(named, from - opened.size() - named);
    const auto fault = [&](const std::string &what) {
      document.faults.push_back(fmt::format("{}: {}: {}", name, fragment, what));
    };
    if (to == std::string::npos || text.find(opening, named) < to) {
      fault("has no end");
      break;
    }
    const std::string shown = text.substr(from, to - from);
    if (!shown.starts_with('\n') && (begins_a_line(text, begin) || begins_a_line(text, to)))
      fault("begins a line");
    std::string right = shown;
    try {
      right = text_of(fragment, sources);
    } catch (const std::exception &error) {
      fault(error.what());
    }
    const bool same = on_one_line(shown) == on_one_line(right);
    if (!same) fault(fmt::format("must be '{}', not '{}'", right, shown));
    document.text += text.substr(done, from - done) + (same ? shown : right);
    done = to;
  }
  document.text += text.substr(done);
  return document;
}

}  // namespace vibro_impact::figures
