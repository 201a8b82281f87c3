#include "page_tables.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>

#include "reference/numbers/panels.hpp"
#include "reference/scenes/paper_scenes.hpp"

namespace vibro_impact::figures {

std::string narrow_table(const std::vector<truth::Cells> &rows) {
  std::string text;
  for (const auto &cells : rows) {
    text += fmt::format("|{}|\n", fmt::join(cells, " |"));
    if (&cells != &rows.front()) continue;
    for (std::size_t k = 0; k < cells.size(); ++k) text += "|---";
    text += "|\n";
  }
  return text;
}

std::string table_of_parameters() {
  const auto window = [](const char *panel) {
    const paper::AxisBox box = paper::panel(panel);
    return fmt::format("{:g}–{:g}", box.from, box.to);
  };
  std::vector<truth::Cells> rows{{"figure", "s1", "s2", "r", "Ω", "t"}};
  const auto add = [&](const char *figure, const paper::NamedScene &run, const std::string &omega,
                       const std::string &t) {
    const auto cell = [&](const char *parameter, const std::string &text) {
      const bool printed = std::ranges::find(run.inferred, parameter) == run.inferred.end();
      return printed ? text : "*" + text + "*";
    };
    const auto number = [](double value) { return fmt::format("{:g}", value); };
    rows.push_back({figure, cell("stop1", number(run.scene.stops[0].position)),
                    cell("stop2", number(run.scene.stops[1].position)),
                    number(run.scene.restitution),
                    cell("omega", omega.empty() ? number(run.scene.omega) : omega), t});
  };
  const std::string phase = "*phase* " + window("figure4");
  add("2", paper::scene_named("figure2"), "", window("figure2a") + "; (b) " + window("figure2b"));
  add("3", {"", paper::figure3(0.25), 0.0}, window("figure3a"), "*steady state*");
  add("4(a)", paper::scene_named("figure4a"), "", phase);
  add("4(b)", paper::scene_named("figure4b"), "", phase);
  add("5(a)", paper::scene_named("figure5a"), "", window("figure5a"));
  add("5(b)", paper::scene_named("figure5b"), "", window("figure5b"));
  add("5(c)", paper::scene_named("figure5c"), "", window("figure5c"));
  return narrow_table(rows);
}

std::string table_of_changes(const Findings &findings) {
  std::vector<truth::Cells> rows{{"mass", "border orbit", "multi-sliding", "jump"}};
  for (const std::string mass : {"1", "2"}) {
    truth::Cells &row = rows.emplace_back(1, mass);
    for (const std::string change : {"border_mass_", "multi_sliding_mass_", "jump_mass_"}) {
      std::vector<std::string> frequencies;
      for (const auto &[number, computed, failure] : findings)
        if (number.id.starts_with(change + mass))
          frequencies.push_back(numbers::formatted(computed, number.format));
      row.push_back(fmt::format("{}", fmt::join(frequencies, ", ")));
    }
  }
  return narrow_table(rows);
}

namespace {

// The runs of frequencies of a procedure.
std::string runs_of(const truth::Rows &table, const std::string &procedure) {
  std::vector<std::string> runs;
  for (const truth::Row &row : table) {
    if (row.cell("procedure") != procedure) continue;
    const std::string &from = row.cell("from"), &to = row.cell("to");
    runs.push_back(from == to ? from : from + "–" + to);
  }
  return runs.empty() ? "none" : fmt::format("{}", fmt::join(runs, ", "));
}

}  // namespace

std::string table_of_procedures(const std::string &tables) {
  const auto windows = truth::read_rows(tables + "/procedures_windows.csv"),
             above = truth::read_rows(tables + "/procedures_sticking.csv"),
             figures = truth::read_rows(tables + "/procedures_figures.csv");
  std::vector<truth::Cells> rows{
      {"procedure", "no complete chatter", "Figure 4", "Figure 5(c)", "above 0.5 (step 0.01)"},
      {"*printed*", "*≈0.3–0.35, ≈0.37–0.4*", "*1, 2*", "*if lower*", "*none*"}};
  for (const truth::Row &row : figures) {
    const std::string &name = row.cell("procedure");
    const bool sticks = row.number("lower_omega") > 0.0 && row.number("lower_r") > 0.0;
    if (row.number("figure5c") > 0.0 || (row.number("lower_omega") > 0.0) != sticks)
      throw std::runtime_error(name + ": Figure 5(c) has a third outcome");
    rows.push_back({name, runs_of(windows, name),
                    fmt::format("{:g}, {:g}", row.number("figure4a"), row.number("figure4b")),
                    sticks ? "if lower" : "never", runs_of(above, name)});
  }
  return narrow_table(rows);
}

}  // namespace vibro_impact::figures
