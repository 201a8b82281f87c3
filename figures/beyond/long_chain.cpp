// Ten masses, stops on three of them: impact velocities against the forcing frequency, from rest.
#include "reference/scenes/extreme_scenes.hpp"

#include <fmt/format.h>

#include "figures/driver.hpp"
#include "figures/frequency_diagram.hpp"

namespace {

using namespace vibro_impact;

void draw(const std::filesystem::path &output) {
  const Grid grid{extremes::long_chain(), {{"omega", 0.05, 0.8, 401}}};
  const std::vector<OrbitRecord> records = sweep(grid, figures::recorded_in_figure3);
  const Scene &scene = grid.scene;
  Table stops("mass,side,stop,beta,restitution,amplitude");
  for (const Stop &stop : scene.stops) {
    stops.row(stop.mass, sign(stop.side), stop.position, scene.beta, scene.restitution,
              scene.amplitude[0]);
    write(figures::impact_velocities(grid, records, stop.mass),
          output / fmt::format("long_chain{}.csv", stop.mass));
  }
  write(stops, output / "long_chain.csv");
  write(figures::sticking(grid, records), output / "long_chain_sticking.csv");
}

}  // namespace

int main(int argc, char **argv) {
  return figures::drive(argc, argv, "Ten masses, stops on three: impact velocities", draw);
}
