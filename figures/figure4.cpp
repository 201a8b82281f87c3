// Figure 4: the hold force on mass 1 over one settled forcing period, just before and just after
// the multi-sliding bifurcation, and at it; and between the sticking phases the force as if mass 1
// were held.
//
// The paper calls it F2 (Eq. 20). It is the force towards +x: the stop of mass 1 is a lower one, so
// a negative force holds the mass to it.
#include "driver.hpp"
#include "measures/runs.hpp"
#include "vibro_impact/analysis/locate.hpp"

namespace {

using namespace vibro_impact;

// The sticking phases of mass 1 in a settled forcing period, with the motion of mass 2.
figures::StickingPhaseRecorder phases_of_mass_1(const Scene &scene) {
  const double period = Clock(scene.omega).period, from = paper::figure4_settling_periods * period;
  figures::StickingPhaseRecorder phases(1, 2, from, from + period, 0.001);
  require_complete(simulate(scene, phases.to, phases));
  return phases;
}

// The hold force on mass 1 in these phases.
Table hold_force(const figures::StickingPhaseRecorder &phases) {
  Table table("phase,t,F2");
  for (const auto &row : phases.rows)
    if (!std::isnan(row.force)) table.row(row.phase, row.time, row.force);
  return table;
}

// The force as if mass 1 were held between these phases: the right-hand side of Eq. 20,
// c x2' + k x2 + A1 cos(Omega t) - 2 k s1.
Table force_between(const figures::StickingPhaseRecorder &phases, const Scene &scene) {
  const double k = scene.stiffness[0], c = scene.beta * k, s1 = scene.stops[0].position;
  Table table("phase,t,F2");
  for (const auto &[phase, kind, time, force, x2, v2] : phases.rows) {
    if (kind != "free" || phase == 0 || phase == phases.phase) continue;
    const double forcing = scene.amplitude[0] * std::cos(scene.omega * time);
    table.row(phase, time, c * v2 + k * x2 + forcing - 2.0 * k * s1);
  }
  return table;
}

void draw(const std::filesystem::path &output) {
  const Scene before = paper::figure4a(), after = paper::figure4b();
  // At the bifurcation the one sticking phase of mass 1 in a forcing period splits in two.
  const auto phases = [](double omega) {
    return figures::settled_sticking_phases(paper::figure3(omega), 1);
  };
  const Scene touching = paper::figure3(bisect(phases, before.omega, after.omega).below);
  write(figures::parameters({before, after, touching}), output / "figure4_scenes.csv");
  const figures::StickingPhaseRecorder two_phases = phases_of_mass_1(after);
  write(hold_force(phases_of_mass_1(before)), output / "figure4a.csv");
  write(hold_force(two_phases), output / "figure4b.csv");
  write(hold_force(phases_of_mass_1(touching)), output / "figure4_at.csv");
  write(force_between(two_phases, after), output / "figure4b_free.csv");
}

}  // namespace

int main(int argc, char **argv) {
  return figures::main_of_driver(
      argc, argv, "Figure 4: hold force on mass 1 about a multi-sliding bifurcation", draw);
}
