// Figure 4: the hold force on mass 1 over one settled forcing period, just before and just after
// the multi-sliding bifurcation, and at it.
//
// The paper calls it F2 (Eq. 20). It is the force towards +x: the stop of mass 1 is a lower one, so
// a negative force holds the mass to it.
#include "driver.hpp"
#include "panel.hpp"

namespace {

using namespace vibro_impact;

void draw(const std::filesystem::path &output) {
  const Scene before = paper::figure4a(), after = paper::figure4b();
  // At the bifurcation the one sticking phase of mass 1 in a forcing period splits in two.
  const auto phases = [](double omega) {
    return figures::settled_sticking_phases(paper::figure3(omega), 1);
  };
  const Scene at = paper::stops_of_different_sign(bisect(phases, before.omega, after.omega).below);
  write(figures::parameters({before, after, at}), output / "figure4_scenes.csv");
  write(figures::hold_force(before), output / "figure4a.csv");
  write(figures::hold_force(after), output / "figure4b.csv");
  write(figures::hold_force(at), output / "figure4_at.csv");
}

}  // namespace

int main(int argc, char **argv) {
  return figures::drive(argc, argv,
                        "Figure 4: hold force on mass 1 about a multi-sliding bifurcation", draw);
}
