// Ten masses, stops on three: the bifurcation diagram from rest, and the classes of the atlas.
//
// long_chain.csv       impact velocities of the masses with stops against the forcing frequency
// long_chain_map.csv   the plane of frequency and restitution: period, who sticks, exponent
#include "reference/scenes/long_chain.hpp"

#include "atlas.hpp"
#include "figures/driver.hpp"
#include "figures/figure3.hpp"

namespace {

using namespace vibro_impact;

constexpr double lowest = 0.05, highest = 0.8;  // frequencies

void draw(const std::filesystem::path &output, int width) {
  const auto points = static_cast<std::size_t>(width);
  const Scene chain = figures::long_chain();
  const Axis omega{{Parameter::Kind::omega}, lowest, highest, 4 * points + 1};
  const Grid line{chain, {omega}};
  const Grid plane{chain,
                   {{{Parameter::Kind::omega}, lowest, highest, points},
                    {{Parameter::Kind::restitution}, 0.0, 0.95, points * 3 / 5}}};
  check(line);
  check(plane);
  Progress progress("long chain", static_cast<double>(line.points() + plane.points()));

  RecordOptions options;
  options.impact_velocities = true;
  options.slowest = paper::slowest_impact_shown;
  Table diagram("omega,mass,v");
  sweep(
      line.points(), [&](std::size_t point) { return record_of(line.scene_at(point), options); },
      [&](std::size_t point, const OrbitRecord &record) {
        for (const Stop &stop : chain.stops)
          for (const double v :
               figures::distinct(record.impact_velocities[static_cast<std::size_t>(stop.mass - 1)]))
            diagram.row(omega.value(point), stop.mass, v);
        progress.advance();
      });
  write(diagram, output / "long_chain.csv");

  options.impact_velocities = false;
  options.lyapunov = true;
  write(figures::map_of(plane, options, progress), output / "long_chain_map.csv");
}

}  // namespace

int main(int argc, char **argv) {
  int width = 100;
  return figures::drive(argc, argv, "Ten masses, stops on three: a diagram and an atlas",
                        [&](const std::filesystem::path &output) { draw(output, width); },
                        {{"--width", "Points of the abscissa of the map", &width}});
}
