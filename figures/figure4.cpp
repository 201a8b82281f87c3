// Figure 4: the hold force on mass 1 over one settled forcing period, just before and just after
// the multi-sliding bifurcation.
//
// The paper calls it F2 (Eq. 20). It is the force towards +x: the stop of mass 1 is a lower one, so
// a negative force holds the mass to it.
#include "driver.hpp"

namespace {

// Sticking phases of mass 1 (counted from 1), time within the period, hold force.
vibro_impact::Table hold_force(const vibro_impact::Scene &scene) {
  using namespace vibro_impact;
  const Clock clock(scene.omega);
  HoldForceRecorder force;
  force.mass = 1;
  force.from = paper::figure4_settling_periods * clock.period;
  force.to = force.from + clock.period;
  force.every = 0.001;
  simulate(scene, force.to, {}, force);
  Table table("phase,t,F2");
  for (const HoldForceRecorder::Row &row : force.rows)
    table.row(row.phase, instant_at(row.time, clock).phase, row.force);
  return table;
}

}  // namespace

int main(int argc, char **argv) {
  using namespace vibro_impact;
  return figures::drive(argc, argv,
                        "Figure 4: hold force on mass 1 about a multi-sliding bifurcation",
                        [](const std::filesystem::path &output) {
                          write(hold_force(paper::figure4a()), output / "figure4a.csv");
                          write(hold_force(paper::figure4b()), output / "figure4b.csv");
                        });
}
