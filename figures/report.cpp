// `make report`: the reproduction report, one HTML page with everything in it, from the template
// figures/report.html, the tables and pictures of `make figures` and those of reference/.
#include <fmt/format.h>

#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>
#include <fstream>
#include <iterator>
#include <sstream>

#include "driver.hpp"
#include "report_template.hpp"
#include "table_reader.hpp"

namespace {

using namespace vibro_impact;
using namespace vibro_impact::figures;
using std::filesystem::path;

std::string read(const path &file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream)
    throw std::runtime_error(file.string() + ": cannot be read (make figures, make check)");
  return {std::istreambuf_iterator<char>(stream), {}};
}

Sheet sheet(const path &file) {
  std::istringstream lines(read(file));
  const std::string header = lines.str().substr(0, lines.str().find('\n'));
  return {file.filename().string(), cells_of(header), read_rows(lines, file.string(), 1)};
}

std::string base64(const std::string &bytes) {
  using namespace boost::archive::iterators;
  using Encoded = base64_from_binary<transform_width<std::string::const_iterator, 6, 8>>;
  std::string text(Encoded(bytes.begin()), Encoded(bytes.end()));
  text.append((3 - bytes.size() % 3) % 3, '=');
  return text;
}

// A cell as shown: a number in so many significant digits, anything else as it is.
std::string shown(const std::string &cell, int digits) {
  const auto value = as_number(cell);
  return value && cell.size() > 8 ? fmt::format("{:.{}g}", *value, digits) : escaped(cell);
}

// Rows of a table, all or those whose first cell begins with `prefix`, the columns named.
std::string table(const Sheet &from, const std::string &columns, const std::string &prefix,
                  int digits) {
  std::vector<std::size_t> kept;
  std::string text = "<div class=wide><table><thead><tr>";
  for (const std::string &column : cells_of(columns)) {
    kept.push_back(from.column(column));
    text += fmt::format("<th>{}</th>", escaped(column));
  }
  text += "</tr></thead><tbody>\n";
  std::size_t rows = 0;
  for (const auto &cells : from.rows) {
    if (!cells[0].starts_with(prefix)) continue;
    ++rows;
    text += "<tr>";
    for (const std::size_t k : kept) {
      const std::string &cell = cells.at(k);
      const char *mark = cell == "pass" ? " class=pass" : cell == "FAIL" ? " class=fail" : "";
      text += fmt::format("<td{}>{}</td>", mark, shown(cell, digits));
    }
    text += "</tr>\n";
  }
  if (rows == 0) throw std::runtime_error("no row begins with " + prefix);
  return text + "</tbody></table></div>";
}

// "7 of 7 pass": the rows whose first cell begins with `prefix`, by their verdict.
std::string verdict(const Sheet &from, const std::string &prefix) {
  const std::size_t column = from.column("verdict");
  int rows = 0, passed = 0;
  for (const auto &cells : from.rows) {
    if (!cells[0].starts_with(prefix)) continue;
    ++rows;
    passed += cells.at(column) == "pass";
  }
  if (rows == 0) throw std::runtime_error("no row begins with " + prefix);
  return fmt::format("<strong class={}>{} of {} numbers reproduced</strong>",
                     rows == passed ? "pass" : "fail", passed, rows);
}

std::string picture(const path &file, const std::string &words) {
  return fmt::format("<figure><img alt=\"{}\" src=\"data:image/png;base64,{}\"></figure>",
                     escaped(words), base64(read(file)));
}

// The value of a key of the manifest, at any depth.
std::string of_manifest(const std::string &manifest, const std::string &key) {
  const std::string mark = fmt::format("\"{}\": \"", key);
  const std::size_t begin = manifest.find(mark);
  if (begin == std::string::npos) throw std::runtime_error("manifest.json: no " + key);
  const std::size_t from = begin + mark.size();
  return escaped(manifest.substr(from, manifest.find('"', from) - from));
}

void report(const path &folder, const path &reference, const path &text, const path &to) {
  const auto at = [&](const std::string &name) {
    const path here = folder / name;
    return std::filesystem::exists(here) ? here : reference / name;
  };
  const Verbs verbs{
      {"picture",
       [&](const Arguments &a) { return picture(folder / (a.at(0) + ".png"), a.at(1)); }},
      {"table",
       [&](const Arguments &a) {
         return table(sheet(at(a.at(0))), a.at(1), a.size() > 2 ? a[2] : "",
                      a.size() > 3 ? std::stoi(a[3]) : 6);
       }},
      {"cell",
       [&](const Arguments &a) {
         const Sheet from = sheet(at(a.at(0)));
         return shown(from.row(a.at(1)).at(from.column(a.at(2))),
                      a.size() > 3 ? std::stoi(a[3]) : 17);
       }},
      {"rows", [&](const Arguments &a) { return std::to_string(sheet(at(a.at(0))).rows.size()); }},
      {"verdict",
       [&](const Arguments &a) { return verdict(sheet(at(a.at(0))), a.size() > 1 ? a[1] : ""); }},
      {"manifest",
       [&](const Arguments &a) { return of_manifest(read(folder / "manifest.json"), a.at(0)); }}};
  Table page("");
  page.text = filled(read(text), verbs);
  write(page, to.string());
}

}  // namespace

int main(int argc, char **argv) {
  std::string output = "build/figures", reference = "reference", text = "figures/report.html",
              to = "build/report.html";
  return command(argc, argv, "The reproduction report as one HTML page",
                 {{"--output", "Folder of the tables and pictures", &output},
                  {"--reference", "Folder of the tables of references", &reference},
                  {"--template", "The text with the places to be filled", &text},
                  {"--report", "The page to be written", &to}},
                 [&] {
                   report(output, reference, text, to);
                   return 0;
                 });
}
