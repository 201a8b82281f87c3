// Figure 3: impact velocities of both masses against the forcing frequency, each from rest; and the
// border orbits and multi-sliding bifurcations of the region of sticking motions.
#include "frequency_diagram.hpp"

#include "driver.hpp"
#include "measures/runs.hpp"

namespace {

using namespace vibro_impact;

// Printed (Section 3.2): the sticking motions exist below this frequency. From rest, mass 1 sticks
// again, in motions whose sticking phases come and go from one frequency to the next.
constexpr double end_of_sticking = 0.5;

// Whether the motion on one side of a change, followed to the other side, keeps its sticking
// phases.
bool goes_on(double omega, double other, int mass, int phases) {
  const MotionState settled =
      state_after_periods(paper::figure3(omega), paper::figure4_settling_periods);
  return figures::followed_sticking_phases(paper::figure3(other), mass, settled) == phases;
}

// The number of sticking phases of a mass changes at a multi-sliding bifurcation, where the hold
// force touches zero inside a phase, and at a border orbit, where a complete chatter becomes
// incomplete. It also changes where the motion from rest jumps from one stable motion to another.
// On the side of a multi-sliding bifurcation with fewer phases a phase is about to split.
const char *kind_of(const CountJump &change, int mass) {
  if (goes_on(change.below, change.above, mass, change.count_below) ||
      goes_on(change.above, change.below, mass, change.count_above))
    return "jump";
  constexpr double touching = 1e-6;  // the force grows by 7 per unit of the frequency
  const bool fewer_below = change.count_below < change.count_above;
  const Scene scene = paper::figure3(fewer_below ? change.below : change.above);
  const MotionState settled = state_after_periods(scene, paper::figure4_settling_periods);
  const auto least =
      least_pressing_force(scene, settled, scene.stops[static_cast<std::size_t>(mass - 1)]);
  return least && least->value < touching ? "multi-sliding" : "border orbit";
}

double phases_per_period(const OrbitRecord &record, int mass) {
  const EventCounts &counts = record.counts;
  return counts.sticks[static_cast<std::size_t>(mass - 1)] / static_cast<double>(counts.periods);
}

// A change of the number of sticking phases of a mass.
struct Bifurcation {
  const char *kind;
  double omega;
};

// The changes between two frequencies, each found by bisection to a width that no plot can show.
// The first change is followed by a search for another one, until the number beyond it is that of
// the upper frequency.
std::vector<Bifurcation> changes_between(double below, double above, int mass) {
  const auto phases = [mass](double omega) {
    return figures::settled_sticking_phases(paper::figure3(omega), mass);
  };
  std::vector<Bifurcation> changes;
  while (phases(below) != phases(above)) {
    const CountJump change = bisect(phases, below, above, 1e-9);
    changes.push_back({kind_of(change, mass), change.below});
    below = change.above;
  }
  return changes;
}

// The changes wherever the number of sticking phases per period changes from one frequency of the
// diagram to the next. These places are searched on all threads.
Table bifurcations(const Grid &grid, const std::vector<OrbitRecord> &records) {
  struct Place {
    int mass;
    double below, above;
  };
  std::vector<Place> places;
  for (const int mass : {1, 2})
    for (std::size_t i = 1; i < records.size(); ++i) {
      const Place place{mass, grid.values(i - 1).front(), grid.values(i).front()};
      if (place.above > end_of_sticking) break;
      if (phases_per_period(records[i - 1], mass) != phases_per_period(records[i], mass))
        places.push_back(place);
    }
  const auto changes = sweep(places.size(), [&](std::size_t k) {
    return changes_between(places[k].below, places[k].above, places[k].mass);
  });
  Table table("mass,kind,omega");
  for (std::size_t k = 0; k < places.size(); ++k)
    for (const Bifurcation &change : changes[k])
      table.row(places[k].mass, change.kind, change.omega);
  return table;
}

void draw(const std::filesystem::path &output) {
  const Grid grid = figures::grid_of_figure3(1801);
  const std::vector<OrbitRecord> records = sweep(grid, figures::recorded_in_figure3);
  write(figures::impact_velocities(grid, records, 1), output / "figure3a.csv");
  write(figures::impact_velocities(grid, records, 2), output / "figure3b.csv");
  write(figures::sticking(grid, records), output / "figure3_sticking.csv");
  write(figures::parameters({grid.scene}), output / "figure3_scenes.csv");
  write(bifurcations(grid, records), output / "figure3_bifurcations.csv");
}

}  // namespace

int main(int argc, char **argv) {
  return vibro_impact::figures::main_of_driver(
      argc, argv, "Figure 3: impact velocities against forcing frequency", draw);
}
