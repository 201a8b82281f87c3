// The frequencies the paper's text does not give, inferred from its axis boxes and its text: every
// value of four digits tried for Figures 2, 5(a) and 5(b), and the rule held against the figures
// whose parameters are printed.
//
// reconstruction_2.csv, _5a.csv, _5b.csv  one row per frequency tried: does it fill the boxes, do
//                                         what the text says, is it left, is it chosen
// reconstruction_axes.csv                 every axis the rule is applied to
#include "reconstruction.hpp"

#include <fmt/format.h>

#include "figures/driver.hpp"

namespace {

using namespace vibro_impact;
using namespace vibro_impact::figures;

// The range scanned, row by row. Returns the frequency chosen.
double scan_to(const std::filesystem::path &file, Trial (*attempt)(double omega),
               const Range &range) {
  const std::vector<Trial> trials = scan(scanned, attempt);
  const double choice = chosen(trials, range);
  std::string header = "omega,lowest,highest";
  for (const auto &[column, value] : trials.front().columns) header += "," + column;
  Table table(header + ",boxes,text,left,chosen");
  for (const Trial &trial : trials) {
    const Range &shown = trial.axes.front().data;
    for (const double cell : {trial.omega, shown.lowest, shown.highest}) table.cell(cell);
    for (const auto &[column, value] : trial.columns) table.cell(value);
    table.row(int{trial.boxes()}, int{trial.text}, int{is_left(trial, range)},
              int{trial.omega == choice});
  }
  write(table, file);
  return choice;
}

// `kind`: printed, chosen by the rule, or refused by it.
void add(Table &table, const std::string &kind, const std::vector<AxisCheck> &checks) {
  for (const AxisCheck &check : checks)
    table.row(check.panel, check.quantity, kind, check.axis.lowest, check.axis.highest, check.tick,
              check.data.lowest, check.data.highest, check.ticks_at_lowest(),
              check.ticks_at_highest(), int{check.passes()});
}

void draw(const std::filesystem::path &output) {
  Progress progress("reconstruction", 4);
  const double figure2 = scan_to(output / "reconstruction_2.csv", try_figure2, scanned_of_figure2);
  progress.advance();
  const double figure5a = scan_to(output / "reconstruction_5a.csv", try_figure5a, scanned);
  progress.advance();
  const double figure5b = scan_to(output / "reconstruction_5b.csv", try_figure5b, scanned);
  progress.advance();
  Table axes(
      "panel,quantity,kind,axis_from,axis_to,tick,lowest,highest,ticks_at_lowest,ticks_at_highest,"
      "fills");
  add(axes, "printed", checks_of_figure3(181));
  add(axes, "printed", checks_of_figure4("4(a)", paper::figure4a()));
  add(axes, "printed", checks_of_figure4("4(b)", paper::figure4b()));
  add(axes, "printed", {check_of_figure5c()});
  add(axes, "chosen", try_figure2(figure2).axes);
  add(axes, "chosen", try_figure5a(figure5a).axes);
  add(axes, "chosen", try_figure5b(figure5b).axes);
  add(axes, "refused", {try_figure2(0.28).axes.at(1), try_figure5b(0.2996).axes.at(0)});
  write(axes, output / "reconstruction_axes.csv");
  progress.advance();
  fmt::print("Omega of Figure 2: {}, 5(a): {}, 5(b): {}\n", figure2, figure5a, figure5b);
}

}  // namespace

int main(int argc, char **argv) {
  return figures::drive(argc, argv, "The frequencies the paper's text does not give", draw);
}
