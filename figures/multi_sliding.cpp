// The multi-sliding bifurcation of Figure 4 at its located frequency: the hold force on mass 1 just
// before, at and just after it.
#include <fmt/format.h>

#include "driver.hpp"
#include "panel.hpp"
#include "vibro_impact/analysis/locate.hpp"

namespace {

using namespace vibro_impact;

void draw(const std::filesystem::path &output) {
  const double before = paper::figure4a().omega, after = paper::figure4b().omega;
  // At the bifurcation the one sticking phase of mass 1 in a forcing period splits in two.
  const auto phases = [](double omega) { return figures::settled_sticking_phases(omega, 1); };
  const double located = bisect(phases, before, after).below;
  Table omegas("when,omega");
  for (const auto &[when, omega] :
       {std::pair{"before", before}, {"at", located}, {"after", after}}) {
    omegas.row(when, omega);
    write(figures::hold_force(paper::stops_of_different_sign(omega)),
          output / fmt::format("multi_sliding_{}.csv", when));
  }
  write(omegas, output / "multi_sliding.csv");
}

}  // namespace

int main(int argc, char **argv) {
  return figures::drive(
      argc, argv, "The hold force on mass 1 before, at and after the multi-sliding bifurcation",
      draw);
}
