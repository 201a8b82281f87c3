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
  Table attractors(
      "plane,attractor,omega,restitution,period,impacts1,impacts2,sticks1,sticks2,share");
  for (const auto &[name, grid] : planes) {
    const figures::Basins basins =
        figures::basins_of(grid, figures::recorded_in_basins(), [&] { progress.advance(); });
    Table table("displacement1,displacement2,attractor");
    for (std::size_t point = 0; point < basins.of.size(); ++point) {
      const std::vector<double> at = grid.values(point);
      table.row(at[0], at[1], basins.of[point]);
    }
    write(table, output / ("basins_" + name + ".csv"));
    for (std::size_t k = 0; k < basins.attractors.size(); ++k) {
      const auto &[record, sections, settled_on_it] = basins.attractors[k];
      const auto rate = [&](int events) { return events / static_cast<double>(record.period); };
      const auto &impacts = record.counts.impacts, &sticks = record.counts.sticks;
      attractors.row(
          name, k + 1, grid.scene.omega, grid.scene.restitution, record.period, rate(impacts[0]),
          rate(impacts[1]), rate(sticks[0]), rate(sticks[1]),
          static_cast<double>(settled_on_it.size()) / static_cast<double>(grid.points()));
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
