// Basins of attraction: the settled motions from the initial displacements of both masses at rest,
// where several motions are stable.
//
// basins1.csv   the stops of Figure 2 at Omega = 0.625
// basins2.csv   Figure 5(b) just below the grazing of mass 2
#include <fmt/format.h>

#include "figures/driver.hpp"
#include "reference/scenes/paper_scenes.hpp"
#include "vibro_impact/analysis/analysis.hpp"

namespace {

using namespace vibro_impact;

// Near the grazing, motions settle slowly.
const RecordOptions options{.settle = {.longest = 1000}};
constexpr std::size_t count = 100;

// Displacements of each mass from its stop to 1.4 away from it.
Grid displacements(const Scene &scene) {
  Grid grid{scene, {}};
  for (const Stop &stop : scene.stops) {
    const double away = stop.position - 1.4 * sign(stop.side);
    grid.axes.push_back({fmt::format("displacement{}", stop.mass), std::min(stop.position, away),
                         std::max(stop.position, away), count});
  }
  return grid;
}

void draw(const std::filesystem::path &output) {
  Scene grazing = paper::figure5b();
  grazing.omega = 0.299518;
  for (const auto &[name, scene] :
       {std::pair{"basins1.csv", paper::figure3(0.625)}, std::pair{"basins2.csv", grazing}}) {
    const Grid grid = displacements(scene);
    Table table = sweep_table(grid, options);
    const std::vector<OrbitRecord> records =
        sweep(grid, [](const Scene &at) { return record_of(at, options); });
    for (std::size_t k = 0; k < records.size(); ++k) add_row(table, grid, options, k, records[k]);
    write(table, output / name);
  }
}

}  // namespace

int main(int argc, char **argv) {
  return figures::drive(argc, argv, "Basins of attraction in the plane of initial displacements",
                        draw);
}
