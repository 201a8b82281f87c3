// The exit boundaries of Section 3.2: where the hold force on a sticking mass changes sign, in the
// plane of the other mass, whose motion it depends on.
//
// Mass 2 (x2 = s2): x1' = -(k/c) x1 + (k/c) s2, fixed. Mass 1 (x1 = s1): x2' = -(k/c) (x2 - 2 s1)
// - (A1/c) cos(Omega t), moving with the forcing.
#include "driver.hpp"
#include "measures/runs.hpp"

namespace {

using namespace vibro_impact;

// The motion of mass `other` while `mass` sticks.
Table orbit_of(const figures::StickingPhaseRecorder &phases) {
  Table table("phase,kind,t,x,v");
  for (const auto &row : phases.rows)
    if (row.kind != "free") table.row(row.phase, row.kind, row.time, row.x, row.v);
  return table;
}

constexpr int periods = 12;  // from rest: the motion settles within them, as the picture shows

void draw(const std::filesystem::path &output) {
  const Scene scene = paper::figure2();
  const double until = periods * Clock(scene.omega).period;
  figures::StickingPhaseRecorder first(1, 2, 0.0, until, 0.005);
  figures::StickingPhaseRecorder second(2, 1, 0.0, until, 0.005);
  require_complete(simulate(scene, until, first, second));
  write(orbit_of(first), output / "exit_boundary1.csv");
  write(orbit_of(second), output / "exit_boundary2.csv");
  // The numbers of the boundaries: k / c, A1 / c and the stops.
  const double rate = 1.0 / scene.beta, forcing = scene.amplitude[0] * rate / scene.stiffness[0];
  Table numbers("omega,rate,forcing,s1,s2,periods");
  numbers.row(scene.omega, rate, forcing, scene.stops[0].position, scene.stops[1].position,
              periods);
  write(numbers, output / "exit_boundary.csv");
}

}  // namespace

int main(int argc, char **argv) {
  return figures::main_of_driver(
      argc, argv, "Exit boundaries of the sticking regions of the Figure 2 scene", draw);
}
