// The frequencies that the paper's text does not give. Every value of four decimals is tried for
// Figures 2, 5(a) and 5(b). The values that fit are printed and marked in the table.
#include "inferred_frequencies.hpp"

#include <fmt/format.h>

#include "driver.hpp"

namespace {

using namespace vibro_impact;
using namespace vibro_impact::figures;

// The range tried: from where a forcing period is longer than any window but Figure 5(c)'s up to
// the end of the sticking region (printed, Section 3.2).
constexpr double lowest = 0.1, highest = 0.5;

void draw(const std::filesystem::path &output) {
  Table table("figure,omega,lowest,boxes,text,drawn");
  const auto add = [&](const char *figure, const Scene &drawn, Trial (*attempt)(double)) {
    fmt::print("Figure {}:", figure);
    for (const Trial &trial : scan(lowest, highest, attempt)) {
      table.row(figure, trial.omega, trial.lowest, int{trial.boxes}, int{trial.text},
                int{trial.omega == drawn.omega});
      if (trial.boxes && trial.text) fmt::print(" {}", trial.omega);
    }
    fmt::print(" fit; {} is drawn\n", drawn.omega);
  };
  add("2", paper::figure2(), try_figure2);
  add("5(a)", paper::figure5a(), try_figure5a);
  add("5(b)", paper::figure5b(), try_figure5b);
  write(table, output / "inferred_frequencies.csv");
}

}  // namespace

int main(int argc, char **argv) {
  return drive(argc, argv, "The frequencies that the paper's text does not give", draw);
}
