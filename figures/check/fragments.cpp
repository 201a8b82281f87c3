#include "fragments.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <regex>
#include <stdexcept>

#include "page_tables.hpp"
#include "reference/truth/event_comparison.hpp"
#include "words.hpp"

namespace vibro_impact::figures {

namespace {

// The cells in some columns of all rows of a table that begin with these cells, to six digits:
// those of a row joined by "to", or one if they are equal, and those of several rows by commas.
std::string cells(const std::string &path, const std::string &first, const std::string &columns,
                  const std::string &format) {
  const truth::Cells begins_with = split(first, ',');
  const auto same = [](const std::string &asked, const std::string &is) {
    const auto one = truth::as_number(asked), other = truth::as_number(is);
    return one && other ? fmt::format("{:g}", *one) == fmt::format("{:g}", *other) : asked == is;
  };
  std::vector<std::string> shown;
  for (const truth::Row &row : truth::read_rows(path)) {
    if (!std::equal(begins_with.begin(), begins_with.end(), row.cells().begin(), same)) continue;
    std::vector<std::string> texts;
    for (const std::string &column : split(columns, '+'))
      texts.push_back(numbers::formatted(std::stod(row.cell(column)), format));
    texts.erase(std::unique(texts.begin(), texts.end()), texts.end());
    shown.push_back(fmt::format("{}", fmt::join(texts, " to ")));
  }
  if (shown.empty()) throw std::runtime_error("no such row");
  return fmt::format("{}", fmt::join(shown, ", "));
}

// How many numbers are of one of some classes, or begin with one of some prefixes.
auto count_of(const Findings &findings, const std::string &asked) {
  const std::vector<std::string> words = split(asked, '+');
  return std::ranges::count_if(findings, [&](const Finding &finding) {
    return std::ranges::any_of(words, [&](const auto &word) {
      return finding.number.id.starts_with(word) || finding.class_name() == with_blanks(word);
    });
  });
}

// --- Documents -----------------------------------------------------------------------------------

// Whether nothing but a bullet stands before this place in its line.
bool begins_a_line(const std::string &text, std::size_t place) {
  const auto last = text.find_last_not_of(" -", place - 1);
  return place == 0 || last == std::string::npos || text[last] == '\n';
}

// The table of the claims of a section, with the fragments that their texts name. A place in the
// paper holds for the rows below, too.
std::string table_of_claims(const std::string &section, const Sources &sources) {
  std::vector<truth::Cells> rows{{"the paper", "here", "class"}};
  std::string place;
  for (const Claim &claim : sources.claims) {
    if (claim.section != section) continue;
    std::string ours;
    for (const std::string &part : split(claim.ours, '{')) {
      const auto end = part.find('}');
      ours += end == std::string::npos
                  ? part
                  : text_of(part.substr(0, end), sources) + part.substr(end + 1);
    }
    rows.push_back({claim.place == place ? claim.words : claim.place + ": " + claim.words, ours,
                    class_of(claim)});
    place = claim.place;
  }
  if (rows.size() == 1) throw std::runtime_error("no claim of that section");
  return narrow_table(rows);
}

}  // namespace

std::string text_of(const std::string &fragment, const Sources &sources) {
  static const std::regex of_a_table(R"((\w+):(.+):([\w+]+):(\S+))");
  if (std::smatch name; std::regex_match(fragment, name, of_a_table))
    return cells(sources.tables + '/' + name.str(1) + ".csv", name[2], name[3], name[4]);
  const std::vector<std::string> parts = split(fragment, ':');
  const std::string &kind = parts.at(0);
  if (kind == "steppers")
    return '\n' + narrow_table(comparison::rows_of_steppers(sources.measured));
  if (kind == "methods") return '\n' + narrow_table(comparison::rows_of_methods(sources.measured));
  if (kind == "grazing_speed") return numbers::formatted(truth::grazing_speed, "g");
  if (kind == "class") return number_of(sources.findings, parts.at(1)).class_name();
  if (kind == "claims") return '\n' + table_of_claims(parts.at(1), sources);
  if (kind == "count_of_claims")
    return fmt::format("{}", count_of_claims(sources.claims, parts.at(1)));
  if (kind == "parameters") return '\n' + table_of_parameters();
  if (kind == "changes_of_sticking") return '\n' + table_of_changes(sources.findings);
  if (kind == "procedures") return '\n' + table_of_procedures(sources.tables);
  if (kind == "count") return fmt::format("{}", count_of(sources.findings, parts.at(1)));
  const auto &[number, computed, failure] = number_of(sources.findings, kind);
  return numbers::formatted(computed, parts.size() > 1 ? parts[1] : number.format);
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
