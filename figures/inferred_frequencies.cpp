// The frequencies that the paper's text does not give. Every value of four decimals is tried for
// Figures 2, 5(a) and 5(b). One table says where each condition holds, the other which values fit.
#include "measures/inferred_frequencies.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "driver.hpp"
#include "measures/runs.hpp"

namespace {

using namespace vibro_impact;
using namespace vibro_impact::figures;

// The range tried: from where a forcing period is longer than any window but Figure 5(c)'s up to
// the end of the sticking region (printed, Section 3.2).
constexpr double lowest = 0.1, highest = 0.5;

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
  Table strips("figure,condition,number,from,to"), fits("figure,omega,drawn");
  for (const InferredFigure &figure : inferred_figures()) {
    const std::vector<Trial> trials = scan(lowest, highest, figure.attempt);
    add_strips(strips, figure, trials);
    std::vector<double> fitting;
    for (const Trial &trial : trials)
      if (trial.fits()) fitting.push_back(trial.omega);
    for (const double omega : fitting)
      fits.row(figure.name, omega, int{omega == figure.drawn.omega});
    fmt::print("Figure {}: {} fit; the rule chooses {}; {} is drawn\n", figure.name,
               fmt::join(fitting, ", "), choice_among(fitting), figure.drawn.omega);
  }
  write(strips, output / "inferred_frequencies.csv");
  write(fits, output / "inferred_frequencies_fits.csv");
}

}  // namespace

int main(int argc, char **argv) {
  return main_of_driver(argc, argv, "The frequencies that the paper's text does not give", draw);
}
