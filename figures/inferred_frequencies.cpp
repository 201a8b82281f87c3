// The frequencies that the paper's text does not give, and that of Figure 5(c), which it gives.
// Every value of four decimals is tried. The tables say where each condition holds, which values
// fit, and how many meet all conditions but that of the axes.
#include "measures/inferred_frequencies.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "driver.hpp"
#include "measures/runs.hpp"

namespace {

using namespace vibro_impact;
using namespace vibro_impact::figures;

// Adds a row for each run of neighbouring frequencies at which a condition holds.
void add_strips(Table &table, const InferredFigure &figure, const std::vector<Trial> &trials) {
  for (std::size_t condition = 0; condition < figure.conditions.size(); ++condition) {
    const auto met = [&](std::size_t i) { return trials[i].met[condition]; };
    for (const auto &[first, last] : runs_where(met, trials.size()))
      table.row(figure.name, figure.conditions[condition], condition + 1, trials[first].omega,
                trials[last].omega);
  }
}

void draw(const std::filesystem::path &output) {
  Table strips("figure,condition,number,from,to"), fits("figure,omega,drawn"),
      axes("figure,fit_without_axes");
  for (const InferredFigure &figure : inferred_figures()) {
    const std::vector<Trial> trials = scan(figure.from, figure.to, figure.attempt);
    add_strips(strips, figure, trials);
    std::vector<double> fitting;
    for (const Trial &trial : trials)
      if (trial.fits()) fitting.push_back(trial.omega);
    axes.row(figure.name, std::ranges::count_if(trials, [](const Trial &trial) {
               return std::all_of(trial.met.begin() + 1, trial.met.end(), std::identity{});
             }));
    for (const double omega : fitting)
      fits.row(figure.name, omega, int{omega == figure.drawn.omega});
    fmt::print("Figure {}: {} fit; the rule chooses {}; {} is drawn\n", figure.name,
               fmt::join(fitting, ", "), choice_among(fitting), figure.drawn.omega);
  }
  write(strips, output / "inferred_frequencies.csv");
  write(fits, output / "inferred_frequencies_fits.csv");
  write(axes, output / "inferred_frequencies_axes.csv");
  // The printed frequency next to that of Figure 5(a): where mass 1 begins its window.
  const double printed = paper::figure4a().omega, from = paper::panel("figure5a").from;
  Table near("omega,x1");
  near.row(printed, require_complete(simulate(with(paper::figure5a(), "omega", printed), from))
                        .state.displacement[0]);
  write(near, output / "inferred_frequencies_near.csv");
}

}  // namespace

int main(int argc, char **argv) {
  return main_of_driver(argc, argv, "The frequencies that the paper's text does not give", draw);
}
