// Figure 4: the hold force on mass 1 over one settled forcing period, just before and just after
// the multi-sliding bifurcation, and at it; and between the sticking phases the force as if mass 1
// were held.
//
// The paper calls it F2 (Eq. 20). It is the force towards +x: the stop of mass 1 is a lower one, so
// a negative force holds the mass to it.
#include "driver.hpp"
#include "panel.hpp"

namespace {

using namespace vibro_impact;

// The right-hand side of Eq. 20, c x2' + k x2 + A1 cos(Omega t) - 2 k s1, along the motion while
// mass 1 is free. `gap` is the number of sticking phases of mass 1 so far.
struct ForceAsIfHeld : Recorder {
  struct Row {
    int gap;
    double phase, force;
  };
  Scene scene;
  double from, to, every;
  std::vector<Row> rows = {};
  int gap = 0;
  std::size_t asked = 0;

  ForceAsIfHeld(const Scene &of, double from_time, double to_time, double every_time)
      : scene(of), from(from_time), to(to_time), every(every_time) {
  }
  double next_time() const override {
    return sample_time(from, to, every, asked);
  }
  void sample(const Moment &moment) override {
    ++asked;
    if (gap == 0 || !std::isnan(moment.hold_force(1))) return;
    const double k = scene.stiffness[0], c = scene.beta * k, s1 = scene.stops[0].position;
    const double forcing = scene.amplitude[0] * std::cos(scene.omega * moment.instant.phase);
    const double force =
        c * moment.velocity(2) + k * moment.displacement(2) + forcing - 2.0 * k * s1;
    rows.push_back({gap, moment.instant.phase, force});
  }
  void event(const Event &event, const Moment &) override {
    if (event.mass == 1 && event.kind == EventKind::stick && event.time >= from) ++gap;
  }
};

// The force as if held between the sticking phases of the forcing period that `hold_force` shows.
Table force_between_phases(const Scene &scene) {
  const double period = Clock(scene.omega).period, from = paper::figure4_settling_periods * period;
  ForceAsIfHeld force(scene, from, from + period, 0.001);
  require_complete(simulate(scene, force.to, force));
  Table table("gap,t,F2");
  for (const auto &row : force.rows)
    if (row.gap < force.gap) table.row(row.gap, row.phase, row.force);
  return table;
}

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
  write(force_between_phases(after), output / "figure4b_free.csv");
}

}  // namespace

int main(int argc, char **argv) {
  return figures::drive(argc, argv,
                        "Figure 4: hold force on mass 1 about a multi-sliding bifurcation", draw);
}
