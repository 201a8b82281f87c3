// The settled motions from rest in the plane of forcing frequency and restitution, at the stops of
// Figures 2 to 4, and the borders of the regions in which a mass sticks.
#include "figures/driver.hpp"
#include "reference/scenes/paper_scenes.hpp"
#include "vibro_impact/analysis/analysis.hpp"

namespace {

using namespace vibro_impact;

// Some 85 per cent of the motions settle in 200 forcing periods.
const RecordOptions options{.settle = {.longest = 200}};
constexpr std::size_t across = 200, upwards = 150;

bool sticks(const OrbitRecord &record, int mass) {
  return record.counts.sticks[static_cast<std::size_t>(mass - 1)] > 0;
}

// A line of the map from one point to its neighbour, along which a mass begins or ceases to stick.
struct Crossing {
  int mass;
  std::vector<double> from, to;  // frequency and restitution
};

// All crossings along the rows and the columns of the map. Points follow each other by columns.
std::vector<Crossing> crossings_of(const Grid &grid, const std::vector<OrbitRecord> &records) {
  std::vector<Crossing> crossings;
  for (const int mass : {1, 2})
    for (std::size_t k = 0; k < records.size(); ++k)
      for (const std::size_t distance : {std::size_t{1}, upwards}) {
        const bool at_edge = distance == 1 ? (k + 1) % upwards == 0 : k + upwards >= records.size();
        if (at_edge || sticks(records[k], mass) == sticks(records[k + distance], mass)) continue;
        crossings.push_back({mass, grid.values(k), grid.values(k + distance)});
      }
  return crossings;
}

// The place on the line, as a part of its length from 0 to 1, by bisection.
double border_on(const Crossing &crossing, const Grid &grid) {
  const auto sticks_at = [&](double part) {
    Scene scene = grid.scene;
    for (std::size_t axis = 0; axis < 2; ++axis)
      scene = with(scene, grid.axes[axis].parameter,
                   crossing.from[axis] + part * (crossing.to[axis] - crossing.from[axis]));
    return int{sticks(record_of(scene, options), crossing.mass)};
  };
  constexpr double width = 0.02;  // no plot shows less
  return bisect(sticks_at, 0.0, 1.0, width).below;
}

void draw(const std::filesystem::path &output) {
  const Grid grid{paper::figure2(),
                  {{"omega", 0.2, 0.8, across}, {"restitution", 0.0, 0.98, upwards}}};
  const std::vector<OrbitRecord> records =
      sweep(grid, [](const Scene &scene) { return record_of(scene, options); });
  Table map = sweep_table(grid, options);
  for (std::size_t k = 0; k < records.size(); ++k) add_row(map, grid, options, k, records[k]);
  write(map, output / "atlas.csv");
  const std::vector<Crossing> crossings = crossings_of(grid, records);
  const std::vector<double> parts =
      sweep(crossings.size(), [&](std::size_t k) { return border_on(crossings[k], grid); });
  Table borders("mass,omega,restitution");
  for (std::size_t k = 0; k < crossings.size(); ++k) {
    const auto &[mass, from, to] = crossings[k];
    borders.row(mass, from[0] + parts[k] * (to[0] - from[0]),
                from[1] + parts[k] * (to[1] - from[1]));
  }
  write(borders, output / "atlas_borders.csv");
}

}  // namespace

int main(int argc, char **argv) {
  return figures::drive(argc, argv, "Atlas of settled motions in the plane of Omega and r", draw);
}
