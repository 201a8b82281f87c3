// The exit boundaries of Section 3.2: where the hold force on a sticking mass changes sign, in the
// plane of the other mass, whose motion it depends on.
//
// Mass 2 (x2 = s2): x1' = -(k/c) x1 + (k/c) s2, fixed. Mass 1 (x1 = s1): x2' = -(k/c) (x2 - 2 s1)
// - (A1/c) cos(Omega t), moving with the forcing.
#include <fmt/format.h>

#include <cmath>

#include "figures/driver.hpp"

namespace {

using namespace vibro_impact;

// The motion of `other` while `mass` sticks: at uniform times, and at the stick and the release.
struct StickingOrbitRecorder {
  int mass, other;
  double from, to, every;
  Table table{"phase,kind,t,x,v"};
  int phase = 0;
  std::size_t asked = 0;

  double next_time() const {
    return sample_time(from, to, every, asked);
  }
  void sample(const Moment &moment) {
    ++asked;
    if (phase > 0 && !std::isnan(moment.hold_force(mass))) row("orbit", moment);
  }
  void event(const Event &event, const Moment &moment) {
    if (event.mass != mass || event.kind == EventKind::impact || event.time < from) return;
    if (event.kind == EventKind::stick) ++phase;
    if (phase > 0) row(name(event.kind), moment);
  }
  // t is the time within the forcing period.
  void row(const char *kind, const Moment &moment) {
    table.row(phase, kind, moment.instant.phase, moment.displacement(other),
              moment.velocity(other));
  }
};

// Frequencies at which mass 2 sticks in another part of the plane (ours).
constexpr double other_omega[] = {0.31, 0.34, 0.43};

void draw(const std::filesystem::path &output) {
  const Scene scene = paper::figure2();
  const double until = 12 * Clock(scene.omega).period;
  StickingOrbitRecorder second{2, 1, 0.0, until, 0.005}, first{1, 2, 0.0, until, 0.005};
  require_complete(simulate(scene, until, {}, first, second));
  write(second.table, output / "exit_boundary2.csv");
  write(first.table, output / "exit_boundary1.csv");
  // The numbers of the boundaries: k / c, A1 / c and the stops.
  const double rate = 1.0 / scene.beta, forcing = scene.amplitude[0] * rate / scene.stiffness[0];
  const double s1 = scene.stops[0].position, s2 = scene.stops[1].position;
  Table scenes("orbit,omega,rate,forcing,s1,s2");
  scenes.row(0, scene.omega, rate, forcing, s1, s2);
  // Mass 2's boundary does not depend on the forcing: at other frequencies, too, it is released
  // there.
  for (int n = 1; n <= 3; ++n) {
    const Scene other = paper::figure3(other_omega[n - 1]);
    scenes.row(n, other.omega, rate, forcing, s1, s2);
    const double period = Clock(other.omega).period;
    StickingOrbitRecorder orbit{2, 1, 40 * period, 41.5 * period, 0.005};
    require_complete(simulate(other, orbit.to, {}, orbit));
    write(orbit.table, output / fmt::format("exit_boundary2_{}.csv", n));
  }
  write(scenes, output / "exit_boundary_scenes.csv");
}

}  // namespace

int main(int argc, char **argv) {
  return figures::drive(argc, argv, "Exit boundaries of the sticking regions of the Figure 2 scene",
                        draw);
}
