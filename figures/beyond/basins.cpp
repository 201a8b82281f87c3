// Basins of attraction: the settled motions from the initial displacements of both masses at rest,
// where several motions are stable.
//
// basins1.csv   the stops of Figure 2 at Omega = 0.625
// basins2.csv   Figure 5(b) just below the grazing of mass 2
#include "figures/driver.hpp"
#include "reference/paper_scenes.hpp"
#include "settled_map.hpp"

namespace {

using namespace vibro_impact;

constexpr int longest = 1000;  // forcing periods: beside the grazing motions settle slowly
constexpr std::size_t count = 100;

// Displacements of each mass from its stop to 1.4 away from it.
Grid displacements(const Scene &scene) {
  Grid grid{scene, {}};
  for (const Stop &stop : scene.stops) {
    const double away = stop.position - 1.4 * sign(stop.side);
    grid.axes.push_back({{Parameter::Kind::displacement, stop.mass},
                         std::min(stop.position, away),
                         std::max(stop.position, away),
                         count});
  }
  return grid;
}

void draw(const std::filesystem::path &output) {
  Scene grazing = paper::figure5b();
  grazing.omega = 0.299518;
  const Grid many = displacements(paper::figure3(0.625)), two = displacements(grazing);
  write(figures::table_of(many, figures::settled_points(many, longest)), output / "basins1.csv");
  write(figures::table_of(two, figures::settled_points(two, longest)), output / "basins2.csv");
}

}  // namespace

int main(int argc, char **argv) {
  return figures::drive(argc, argv, "Basins of attraction in the plane of initial displacements",
                        draw);
}
