// Figure 4: the hold force on mass 1 over one settled forcing period, just before and just after
// the multi-sliding bifurcation.
//
// The paper calls it F2 (Eq. 20). It is the force towards +x: the stop of mass 1 is a lower one, so
// a negative force holds the mass to it.
#include "driver.hpp"
#include "panel.hpp"

int main(int argc, char **argv) {
  using namespace vibro_impact;
  return figures::drive(argc, argv,
                        "Figure 4: hold force on mass 1 about a multi-sliding bifurcation",
                        [](const std::filesystem::path &output) {
                          write(figures::hold_force(paper::figure4a()), output / "figure4a.csv");
                          write(figures::hold_force(paper::figure4b()), output / "figure4b.csv");
                        });
}
