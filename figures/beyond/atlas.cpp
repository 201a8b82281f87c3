// The atlas of settled motions from rest, in the planes of two parameters.
//
// atlas_omega_r.csv    forcing frequency and restitution, at the stops of Figures 2 to 4
// atlas_omega_A1.csv   forcing frequency and amplitude, likewise
// atlas_5a.csv ..      positions of the two stops, at the frequencies of Figures 5(a) to (c)
// atlas_scenes.csv     where the paper's scenes stand in these planes
#include "atlas.hpp"

#include <array>
#include <string>
#include <tuple>
#include <utility>

#include "figures/driver.hpp"
#include "reference/paper_scenes.hpp"

namespace {

using namespace vibro_impact;

struct Plane {
  std::string name;
  Grid grid;
};

Axis axis(const char *parameter, double from, double to, int count) {
  return {parameter_named(parameter), from, to, static_cast<std::size_t>(count)};
}

// `width` x `height` points in the planes of the frequency, fewer in those of the stops: a long
// period takes long.
std::array<Plane, 5> planes(int width, int height) {
  const Axis omega = axis("omega", 0.2, 0.8, width);
  const auto stops = [&](const Scene &scene, int part) {
    return Grid{
        scene,
        {axis("stop1", 0.0, 0.6, width * part / 10), axis("stop2", 0.0, 0.6, height * part / 10)}};
  };
  return {{{"omega_r", {paper::figure2(), {omega, axis("restitution", 0.0, 0.98, height)}}},
           {"omega_A1", {paper::figure2(), {omega, axis("amplitude1", 0.02, 1.2, height)}}},
           {"5a", stops(paper::figure5a(), 5)},
           {"5b", stops(paper::figure5b(), 5)},
           {"5c", stops(paper::figure5c(), 2)}}};
}

// Within 200 forcing periods some 85 per cent settle in the planes of the frequency.
RecordOptions what_is_shown() {
  RecordOptions options;
  options.settle.longest = 200;
  options.lyapunov = true;
  options.pairs = true;
  return options;
}

Table scenes() {
  Table table("plane,x,y,figure");
  for (const auto &[scene, figure] :
       {std::pair{paper::figure2(), "2"}, std::pair{paper::figure4a(), "4"}}) {
    table.row("omega_r", scene.omega, scene.restitution, figure);
    table.row("omega_A1", scene.omega, scene.amplitude[0], figure);
  }
  for (const auto &[plane, scene, figure] :
       {std::tuple{"5a", paper::figure5a(), "5(a)"}, std::tuple{"5b", paper::figure5b(), "5(b)"},
        std::tuple{"5c", paper::figure5c(), "5(c)"}})
    table.row(plane, scene.stops[0].position, scene.stops[1].position, figure);
  return table;
}

void draw(const std::filesystem::path &output, int width, int height) {
  const auto all = planes(width, height);
  const RecordOptions options = what_is_shown();
  double points = 0.0;
  for (const Plane &plane : all) points += static_cast<double>(plane.grid.points());
  Progress progress("atlas", points);
  for (const Plane &plane : all) check(plane.grid);
  for (const Plane &plane : all)
    write(figures::map_of(plane.grid, options, progress),
          output / ("atlas_" + plane.name + ".csv"));
  write(scenes(), output / "atlas_scenes.csv");
}

}  // namespace

int main(int argc, char **argv) {
  int width = 400, height = 300;
  return figures::drive(argc, argv, "Atlas of settled motions in the planes of two parameters",
                        [&](const std::filesystem::path &output) { draw(output, width, height); },
                        {{"--width", "Points of the abscissa", &width},
                         {"--height", "Points of the ordinate", &height}});
}
