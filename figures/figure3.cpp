// Figure 3: impact velocities of both masses against the forcing frequency, each motion from rest.
// The tables are those that `vibro-impact sweep` writes of the same grid.
#include "driver.hpp"
#include "measures/runs.hpp"

namespace {

using namespace vibro_impact;

void draw(const std::filesystem::path &output) {
  const Grid grid = figures::grid_of_figure3(1801);
  const RecordOptions &options = figures::recorded_of_figure3;
  const std::vector<OrbitRecord> records =
      sweep(grid, [&](const Scene &scene) { return record_of(scene, options); });
  SweepTables tables = sweep_tables(grid, options);
  for (std::size_t point = 0; point < records.size(); ++point)
    add_rows(tables, grid, options, point, records[point]);
  write(tables.records, output / "figure3_records.csv");
  write(tables.impacts, output / "figure3_impacts.csv");
  write(figures::parameters({grid.scene}), output / "figure3_scenes.csv");
}

}  // namespace

int main(int argc, char **argv) {
  return vibro_impact::figures::main_of_driver(
      argc, argv, "Figure 3: impact velocities against forcing frequency", draw);
}
