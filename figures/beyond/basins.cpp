// Basins of attraction in the plane of the initial displacements, where attractors coexist.
//
// basins_<plane>.csv      one row per initial state: the number of the attractor, 0: not settled
// basins_attractors.csv   what these are: period, impacts and sticks per forcing period, share
#include "basins.hpp"

#include "figures/driver.hpp"

namespace {

using namespace vibro_impact;

void draw(const std::filesystem::path &output, int count) {
  const auto planes = figures::basin_planes(count);
  double points = 0.0;
  for (const auto &plane : planes) points += static_cast<double>(plane.grid.points());
  Progress progress("basins", points);
  double before = 0.0;
  SweepOptions sweeping;
  sweeping.progress = [&](std::size_t done) { progress.reach(before + static_cast<double>(done)); };
  Table attractors(
      "plane,attractor,omega,restitution,period,impacts1,impacts2,sticks1,sticks2,share");
  for (const auto &[name, grid] : planes) {
    const figures::Basins basins =
        figures::basins_of(grid, figures::recorded_in_basins(), sweeping);
    before += static_cast<double>(grid.points());
    Table table("displacement1,displacement2,attractor");
    for (std::size_t point = 0; point < basins.of.size(); ++point) {
      const std::vector<double> at = grid.values(point);
      table.row(at[0], at[1], basins.of[point]);
    }
    write(table, output / ("basins_" + name + ".csv"));
    for (std::size_t k = 0; k < basins.attractors.size(); ++k) {
      const auto &[record, sections, settled_on_it, met] = basins.attractors[k];
      for (const auto &cell : {name, std::to_string(k + 1)}) attractors.cell(cell);
      attractors.cell(grid.scene.omega);
      attractors.cell(grid.scene.restitution);
      attractors.cell(record.period);
      for (const auto *counts : {&record.counts.impacts, &record.counts.sticks})
        for (const int n : *counts) attractors.cell(n / static_cast<double>(record.period));
      attractors.row(static_cast<double>(settled_on_it) / static_cast<double>(grid.points()));
    }
  }
  write(attractors, output / "basins_attractors.csv");
}

}  // namespace

int main(int argc, char **argv) {
  int count = 100;
  return figures::drive(argc, argv, "Basins of attraction in the plane of initial displacements",
                        [&](const std::filesystem::path &output) { draw(output, count); },
                        {{"--count", "Initial displacements of each mass", &count}});
}
