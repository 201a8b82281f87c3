// The frequencies the paper's text does not give, inferred from its axis boxes and its text: every
// value of four digits tried for Figures 2, 5(a) and 5(b), and the rule held against the figures
// whose parameters are printed.
//
// reconstruction_2.csv, _5a.csv, _5b.csv  one row per frequency tried: does it fill the boxes, do
//                                         what the text says, is it left, is it chosen
// reconstruction_axes.csv                 every axis the rule is applied to
#include "reconstruction.hpp"

#include <fmt/format.h>

#include "axis_checks.hpp"
#include "driver.hpp"

namespace {

using namespace vibro_impact;
using namespace vibro_impact::figures;

const std::string flags = ",boxes,text,left,chosen";

struct Flags {
  int boxes, text, left, chosen;
};

template <class Trial>
Flags flags_of(const Trial &trial, const Range &range, double choice) {
  return {trial.verdict.boxes, trial.verdict.text, is_left(trial, range), trial.omega == choice};
}

double scan_figure2(const std::filesystem::path &output) {
  const auto trials = scan(scanned, try_figure2);
  const double choice = chosen(trials, scanned_of_figure2);
  Table table("omega,lowest,highest,lowest_x2_in_b,begins,complete,unevenness" + flags);
  for (const Figure2Trial &t : trials) {
    const Flags f = flags_of(t, scanned_of_figure2, choice);
    table.row(t.omega, t.shown.lowest, t.shown.highest, t.close_up.lowest, t.begins, t.complete,
              t.verdict.apart, f.boxes, f.text, f.left, f.chosen);
  }
  write(table, output / "reconstruction_2.csv");
  return choice;
}

double scan_figure5a(const std::filesystem::path &output) {
  const auto trials = scan(scanned, try_figure5a);
  const double choice = chosen(trials, scanned);
  Table table("omega,lowest,highest,begins,complete,released,impacts" + flags);
  for (const Figure5aTrial &t : trials) {
    const Flags f = flags_of(t, scanned, choice);
    table.row(t.omega, t.shown.lowest, t.shown.highest, t.begins, t.complete, t.released, t.impacts,
              f.boxes, f.text, f.left, f.chosen);
  }
  write(table, output / "reconstruction_5a.csv");
  return choice;
}

double scan_figure5b(const std::filesystem::path &output) {
  const auto trials = scan(scanned, try_figure5b);
  const double choice = chosen(trials, scanned);
  Table table("omega,lowest,highest,nearest_time,gap" + flags);
  for (const Figure5bTrial &t : trials) {
    const Flags f = flags_of(t, scanned, choice);
    table.row(t.omega, t.shown.lowest, t.shown.highest, t.nearest_time, t.gap, f.boxes, f.text,
              f.left, f.chosen);
  }
  write(table, output / "reconstruction_5b.csv");
  return choice;
}

// `kind`: printed, chosen by the rule, or refused by it.
void add(Table &table, const std::string &kind, const std::vector<AxisCheck> &checks) {
  for (const AxisCheck &check : checks) {
    const TicksInside inside = ticks_inside(check.data, check.axis, check.tick);
    table.row(check.panel, check.quantity, kind, check.axis.lowest, check.axis.highest, check.tick,
              check.data.lowest, check.data.highest, inside.at_lowest, inside.at_highest,
              int{check.passes()});
  }
}

void draw(const std::filesystem::path &output) {
  Progress progress("reconstruction", 4);
  const double figure2 = scan_figure2(output);
  progress.advance();
  const double figure5a = scan_figure5a(output);
  progress.advance();
  const double figure5b = scan_figure5b(output);
  progress.advance();
  Table axes(
      "panel,quantity,kind,axis_from,axis_to,tick,lowest,highest,ticks_at_lowest,ticks_at_highest,"
      "fills");
  add(axes, "printed", checks_of_figure3(181));
  add(axes, "printed", checks_of_figure4("4(a)", paper::figure4a()));
  add(axes, "printed", checks_of_figure4("4(b)", paper::figure4b()));
  add(axes, "printed", {check_of_figure5c()});
  add(axes, "chosen", checks_of_figure2(figure2));
  add(axes, "chosen", {check_of_figure5a(figure5a), check_of_figure5b(figure5b)});
  add(axes, "refused", {checks_of_figure2(0.28).at(1), check_of_figure5b(0.2996)});
  write(axes, output / "reconstruction_axes.csv");
  progress.advance();
  fmt::print("Omega of Figure 2: {}, 5(a): {}, 5(b): {}\n", figure2, figure5a, figure5b);
}

}  // namespace

int main(int argc, char **argv) {
  return figures::drive(argc, argv, "The frequencies the paper's text does not give", draw);
}
