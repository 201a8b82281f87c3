// The multi-sliding bifurcation of Figure 4 at its located frequency: the hold force on mass 1 just
// before, at and just after it.
#include <fmt/format.h>

#include "driver.hpp"
#include "panel.hpp"
#include "vibro_impact/analysis/analysis.hpp"

namespace {

using namespace vibro_impact;

// The least force that presses mass 1 into its stop inside a sticking phase of the periodic orbit.
// It falls to zero as the frequency rises to the bifurcation.
double least_force(double omega) {
  const Scene scene = paper::stops_of_different_sign(omega);
  const MotionState near = at_quiet_phase(scene, settled(scene, paper::figure4_settling_periods));
  return least_pressing_force(scene, orbit_near(scene, near, 1), scene.stops[0]).value().value;
}

void draw(const std::filesystem::path &output) {
  const double before = paper::figure4a().omega, after = paper::figure4b().omega;
  const Located found = zero_from_one_side(least_force, before - 1e-4, before);
  Table omegas("when,omega");
  for (const auto &[when, omega] :
       {std::pair{"before", before}, {"at", found.value}, {"after", after}}) {
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
