// `make report`: the reproduction report, one HTML page with everything in it, from the tables and
// pictures that `make figures` and `make beyond` have left. Every number is looked up.
#include <fmt/format.h>

#include <algorithm>
#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>
#include <iterator>
#include <sstream>

#include "driver.hpp"
#include "printed.hpp"
#include "reference/table_reader.hpp"

namespace {

using namespace vibro_impact;
using namespace vibro_impact::figures;
using std::filesystem::path;

constexpr const char *head = R"(<!DOCTYPE html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>Reproduction report: Wagg (2006), multiple nonsmooth events</title>
<style>
  body { font: 17px/1.5 Georgia, "Liberation Serif", serif; color: #1c1c1c; max-width: 52rem;
         margin: 0 auto; padding: 1rem; }
  h1 { font-size: 1.6rem; }
  h2 { font-size: 1.25rem; margin-top: 2.2rem; border-top: 1px solid #ccc; }
  img { max-width: 100%; height: auto; } .wide { overflow-x: auto; }
  table { border-collapse: collapse; font-size: .82rem; width: 100%; }
  th, td { text-align: left; padding: .15rem .5rem .15rem 0; border-bottom: 1px solid #e4e4e4;
           vertical-align: top; font-variant-numeric: tabular-nums; }
  .agrees { color: #1d6b3a; } .differs, .FAIL { color: #b3261e; } pre { overflow-x: auto; }
  @media (max-width: 30rem) { table { font-size: .64rem; } th, td { padding-right: .2rem; } }
  @media print { body { font-size: 10pt; max-width: none; } tr, img { break-inside: avoid; } }
</style>
<h1>Reproduction report</h1>
<p>D. J. Wagg, <cite>Multiple nonsmooth events in multi-degree-of-freedom vibro-impact
systems</cite>, Nonlinear Dynamics 43 (2006) 137-148,
<a href="https://doi.org/10.1007/s11071-006-0757-7">doi 10.1007/s11071-006-0757-7</a>.
All quantities are non-dimensional. The text of the paper that we have gives neither Omega of
Figures 2, 5(a) and 5(b), nor s1 of Figure 5(b) and the stops of Figure 5(c), nor where the time
axis of Figure 4 begins; they are inferred from that text and from the axes of the plots
(figures/README.md).</p>
)";

std::string escaped(const std::string &text) {
  std::string result;
  for (const char c : text)
    result += c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '&' ? "&amp;" : std::string(1, c);
  return result;
}

std::string base64(const std::string &bytes) {
  using namespace boost::archive::iterators;
  using Encoded = base64_from_binary<transform_width<std::string::const_iterator, 6, 8>>;
  std::string text(Encoded(bytes.begin()), Encoded(bytes.end()));
  text.append((3 - bytes.size() % 3) % 3, '=');
  return text;
}

std::string picture(const path &file, const std::string &title) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return fmt::format("<p>{} is not drawn (make beyond).</p>\n", file.stem().string());
  return fmt::format("<p><img alt=\"{}\" src=\"data:image/png;base64,{}\"></p>\n", title,
                     base64({std::istreambuf_iterator<char>(stream), {}}));
}

// The columns named of some rows, headed by their names; a cell's first word is its class.
std::string table(const std::vector<std::pair<std::string, std::size_t>> &columns,
                  const Rows &rows) {
  std::string text = "<div class=wide><table><tr>";
  for (const auto &[name, at] : columns) text += fmt::format("<th>{}</th>", name);
  for (const auto &cells : rows) {
    text += "</tr>\n<tr>";
    for (const auto &[name, at] : columns)
      text += fmt::format("<td class=\"{}\">{}</td>",
                          name == "verdict" ? cells[at].substr(0, cells[at].find(' ')) : "",
                          escaped(cells[at]));
  }
  return text + "</tr></table></div>\n";
}

const std::vector<std::pair<std::string, std::size_t>> columns_of_keys{
    {"number", column::meaning},    {"the paper says", column::printed},
    {"computed", column::computed}, {"error", column::error},
    {"allowed", column::allowed},   {"verdict", column::verdict}};

// The rows of which a cell begins with this.
std::size_t count(const Rows &rows, const char *beginning, std::size_t cell) {
  return static_cast<std::size_t>(std::count_if(
      rows.begin(), rows.end(), [&](const auto &row) { return row[cell].starts_with(beginning); }));
}

// report_sections.csv: titles, pictures, the beginnings of the symbols of the key numbers that
// belong to them, and what they show.
std::string page(const path &folder) {
  const Rows keys = read_rows(folder / "key_numbers_checked.csv", 10),
             others = read_rows(folder / "published_checked.csv", 9);
  std::string text = head;
  const auto verdicts = [&](const char *beginning) {
    return count(keys, beginning, column::verdict);
  };
  text += fmt::format(
      "<p>Of {} key numbers <strong class=agrees>{} agree with the paper</strong>, within what its "
      "print or plot can tell (half a unit of the last digit printed; between two ticks, where an "
      "axis ends; a twentieth of the distance of the ticks where a value is read off Figure 3), "
      "<strong class=differs>{} differ from it</strong>, and <strong>{} are not in it</strong>. {} "
      "of {} are within tolerance of their references, 50 digits or formulas; of {} results that "
      "others have published, {} are.</p>\n",
      keys.size(), verdicts("agrees"), verdicts("differs"), verdicts("not"),
      count(keys, "pass", column::met), keys.size(), others.size(), count(others, "pass", 8));
  for (const auto &section : read_rows("figures/report_sections.csv", 4)) {
    text += fmt::format("<h2>{}</h2>\n<p>{}</p>\n", section[0], section[3]);
    if (!section[1].empty()) text += picture(folder / (section[1] + ".png"), section[0]);
    Rows rows;
    std::istringstream beginnings(section[2]);
    for (std::string beginning; beginnings >> beginning;)
      for (const auto &row : keys)
        if (row[column::symbol].starts_with(beginning)) rows.push_back(row);
    if (!rows.empty()) text += table(columns_of_keys, rows);
  }
  text +=
      "<h2>Published by others</h2>\n<p>Each result is a row of reference/published.csv, which has "
      "its parameters; sources: reference/README.md.</p>\n";
  text += table({{"result", 0},
                 {"quantity", 2},
                 {"printed", 3},
                 {"computed", 4},
                 {"difference", 5},
                 {"allowed", 6},
                 {"limited by", 7},
                 {"verdict", 8}},
                others);
  std::ifstream manifest = opened((folder / "SHA256SUMS").string());
  text += "<h2>Made with</h2>\n<pre>";
  for (std::string line; std::getline(manifest, line) && line.starts_with('#');)
    text += escaped(line.substr(2)) + "\n";
  return text + "</pre>\n";
}

}  // namespace

int main(int argc, char **argv) {
  std::string output = "build/figures";
  return command(argc, argv, "The reproduction report as one HTML page, build/report.html",
                 {{"--output", "Folder of the tables and pictures", &output}}, [&] {
                   Table text("");
                   text.text = page(output);
                   write(text, "build/report.html");
                   return 0;
                 });
}
